#include "calib/camera_model.hpp"

#include <cmath>
#include <cstdio>

namespace autostereo::calib {

namespace {

/// Radial factor of the rational model and its derivative by r^2.
struct Radial {
    double factor;
    double slope;
};

Radial radialAt(const Distortion& k, double r2) {
    const double numerator = 1 + r2 * (k.k1 + r2 * (k.k2 + r2 * k.k3));
    const double denominator = 1 + r2 * (k.k4 + r2 * (k.k5 + r2 * k.k6));
    const double numeratorSlope = k.k1 + r2 * (2 * k.k2 + r2 * 3 * k.k3);
    const double denominatorSlope = k.k4 + r2 * (2 * k.k5 + r2 * 3 * k.k6);
    return {numerator / denominator, (numeratorSlope * denominator - numerator * denominatorSlope) /
                                         (denominator * denominator)};
}

/// Derivative of `distort`; symmetric.
struct Jacobian {
    double xx, xy, yy;
    [[nodiscard]] double determinant() const { return xx * yy - xy * xy; }
};

Jacobian jacobianAt(const Distortion& k, const glm::dvec2& ray) {
    const double x = ray.x, y = ray.y;
    const auto [radial, slope] = radialAt(k, x * x + y * y);
    return {radial + 2 * x * x * slope + 2 * k.p1 * y + 6 * k.p2 * x,
            2 * x * y * slope + 2 * k.p1 * x + 2 * k.p2 * y,
            radial + 2 * y * y * slope + 6 * k.p1 * y + 2 * k.p2 * x};
}

/// Between the axis and `ray` the model turns back: Newton's method leapt across a fold.
bool beyondFold(const Distortion& k, const glm::dvec2& ray) {
    constexpr int kSamples = 16;
    for (int i = 1; i <= kSamples; ++i)
        if (!(jacobianAt(k, ray * (static_cast<double>(i) / kSamples)).determinant() > 0))
            return true;
    return false;
}

std::string phrase(const char* name, double value, const char* allowed) {
    char text[128];
    std::snprintf(text, sizeof text, "%s = %g (allowed %s)", name, value, allowed);
    return text;
}

} // namespace

glm::dvec2 distort(const Distortion& k, const glm::dvec2& ray) {
    const double x = ray.x, y = ray.y, r2 = x * x + y * y;
    const double radial = radialAt(k, r2).factor;
    return {x * radial + 2 * k.p1 * x * y + k.p2 * (r2 + 2 * x * x),
            y * radial + k.p1 * (r2 + 2 * y * y) + 2 * k.p2 * x * y};
}

glm::dmat2 distortSlope(const Distortion& k, const glm::dvec2& ray) {
    const Jacobian slope = jacobianAt(k, ray);
    return {slope.xx, slope.xy, slope.xy, slope.yy};
}

std::optional<glm::dvec2> CameraModel::project(const glm::dvec3& point) const {
    if (!(point.z > 0)) return std::nullopt;
    const glm::dvec2 ray{point.x / point.z, point.y / point.z};
    if (!(ray.x * ray.x + ray.y * ray.y <= distortion.metricRadius * distortion.metricRadius))
        return std::nullopt;
    const glm::dvec2 bent = distort(distortion, ray);
    const glm::dvec2 pixel{bent.x * intrinsics.fx + intrinsics.cx,
                           bent.y * intrinsics.fy + intrinsics.cy};
    if (!std::isfinite(pixel.x) || !std::isfinite(pixel.y)) return std::nullopt;
    return pixel;
}

std::optional<glm::dvec2> CameraModel::unproject(const glm::dvec2& pixel) const {
    const glm::dvec2 bent{(pixel.x - intrinsics.cx) / intrinsics.fx,
                          (pixel.y - intrinsics.cy) / intrinsics.fy};
    const Distortion& k = distortion;
    constexpr int kMostSteps = 20;
    constexpr double kConverged = 1e-12; // on the z = 1 plane: far below a millionth of a pixel
    glm::dvec2 ray = bent;
    for (int step = 0; step < kMostSteps; ++step) {
        const glm::dvec2 error = distort(k, ray) - bent;
        const double r2 = ray.x * ray.x + ray.y * ray.y;
        if (!std::isfinite(r2)) return std::nullopt;
        const Jacobian slope = jacobianAt(k, ray);
        // Where the model folds back, pixels have two rays or none.
        if (!(slope.determinant() > 0)) return std::nullopt;
        if (std::abs(error.x) < kConverged && std::abs(error.y) < kConverged) {
            if (r2 > k.metricRadius * k.metricRadius || beyondFold(k, ray)) return std::nullopt;
            return ray;
        }
        ray -= glm::dvec2{slope.yy * error.x - slope.xy * error.y,
                          slope.xx * error.y - slope.xy * error.x} /
               slope.determinant();
    }
    return std::nullopt;
}

CameraModel CameraModel::resized(int width, int height) const {
    CameraModel result = *this;
    const double sx = static_cast<double>(width) / intrinsics.width;
    const double sy = static_cast<double>(height) / intrinsics.height;
    result.intrinsics = {width,
                         height,
                         intrinsics.fx * sx,
                         intrinsics.fy * sy,
                         (intrinsics.cx + 0.5) * sx - 0.5,
                         (intrinsics.cy + 0.5) * sy - 0.5};
    return result;
}

std::optional<std::string> problemWith(const CameraModel& camera) {
    constexpr int kLargest = 16384;
    const Intrinsics& i = camera.intrinsics;
    if (i.width < 1 || i.width > kLargest) return phrase("width", i.width, "1 to 16384");
    if (i.height < 1 || i.height > kLargest) return phrase("height", i.height, "1 to 16384");
    if (!std::isfinite(i.fx) || !(i.fx > 0)) return phrase("fx", i.fx, "a number > 0");
    if (!std::isfinite(i.fy) || !(i.fy > 0)) return phrase("fy", i.fy, "a number > 0");
    if (!std::isfinite(i.cx)) return phrase("cx", i.cx, "a number");
    if (!std::isfinite(i.cy)) return phrase("cy", i.cy, "a number");
    const Distortion& k = camera.distortion;
    for (const double term : {k.k1, k.k2, k.p1, k.p2, k.k3, k.k4, k.k5, k.k6})
        if (!std::isfinite(term)) return phrase("distortion", term, "finite numbers");
    if (!(k.metricRadius > 0)) return phrase("metric_radius", k.metricRadius, "> 0");
    return std::nullopt;
}

} // namespace autostereo::calib

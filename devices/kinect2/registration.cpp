#include "devices/kinect2/registration.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::devices::kinect2 {

namespace {

// Scales of the factory's units.
constexpr double kPerDepthPixel = 0.01;
constexpr double kPerColorPixel = 0.002199;

double cubic(const std::array<double, ColorCalibration::kTerms>& terms, double x, double y) {
    const std::array<double, ColorCalibration::kTerms> powers{
        x * x * x, y * y * y, x * x * y, x * y * y, x * x, y * y, x * y, x, y, 1};
    double sum = 0;
    for (std::size_t i = 0; i < powers.size(); ++i)
        sum += terms[i] * powers[i];
    return sum;
}

RegistrationCheck check(const ColorCalibration& color, const DepthCamera& depth,
                        bool withoutDistortion) {
    const calib::Intrinsics& lens = depth.model.intrinsics;
    RegistrationCheck result;
    result.withoutDistortion = withoutDistortion;
    double squares = 0;
    for (std::size_t row = 0; row < ColorCalibration::kCheckRows; ++row)
        for (std::size_t column = 0; column < ColorCalibration::kCheckColumns; ++column) {
            const auto& infrared = color.irCentroids[row][column];
            const auto& seen = color.colorCentroids[row][column];
            const double depthMm = color.checkDepthsMm[row][column];
            // Page 3 counts from the corner of the first pixel.
            const glm::dvec2 pixel{infrared.x - 0.5, infrared.y - 0.5};
            const glm::dvec2 straight{(pixel.x - lens.cx) / lens.fx, (pixel.y - lens.cy) / lens.fy};
            const auto ray = withoutDistortion ? straight : depth.model.unproject(pixel);
            if (!(depthMm > 0) || !ray) continue;
            const glm::dvec2 expected = colorPixel(color, depth, *ray, depthMm);
            const double error = std::hypot(expected.x - seen.x, expected.y - seen.y);
            if (!std::isfinite(error)) continue;
            ++result.points;
            squares += error * error;
            result.worstPx = std::max(result.worstPx, error);
        }
    if (result.points > 0) result.rmsPx = std::sqrt(squares / result.points);
    return result;
}

} // namespace

glm::dvec2 colorPixel(const ColorCalibration& color, const DepthCamera& depth,
                      const glm::dvec2& ray, double depthMm) {
    const double x = ray.x * depth.model.intrinsics.fx * kPerDepthPixel;
    const double y = ray.y * depth.model.intrinsics.fy * kPerDepthPixel;
    const double parallax =
        color.focal * color.displacementMm * (1 / depthMm - 1 / color.nominalDepthMm);
    return {cubic(color.xTerms, x, y) / kPerColorPixel + parallax + color.cx,
            cubic(color.yTerms, x, y) / kPerColorPixel + color.cy};
}

RegistrationCheck checkRegistration(const ColorCalibration& color, const DepthCamera& depth) {
    const RegistrationCheck before = check(color, depth, false);
    const RegistrationCheck after = check(color, depth, true);
    return after.rmsPx < before.rmsPx ? after : before;
}

} // namespace autostereo::devices::kinect2

#include "tests/support/panel_camera.hpp"

#include "calib/srgb.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace autostereo::test {

namespace {

/// Light in three colours.
struct Plate {
    int width, height;
    std::vector<std::array<float, 3>> pixels;

    [[nodiscard]] std::array<float, 3> at(int x, int y) const {
        if (x < 0 || y < 0 || x >= width || y >= height) return {};
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    /// Between the four pixels around (centres at whole numbers).
    [[nodiscard]] std::array<float, 3> between(double x, double y) const {
        const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
        const auto fx = static_cast<float>(x - left), fy = static_cast<float>(y - top);
        const auto a = at(left, top), b = at(left + 1, top), c = at(left, top + 1),
                   d = at(left + 1, top + 1);
        std::array<float, 3> mixed{};
        for (std::size_t i = 0; i < 3; ++i)
            mixed.at(i) = (1 - fy) * ((1 - fx) * a.at(i) + fx * b.at(i)) +
                          fy * ((1 - fx) * c.at(i) + fx * d.at(i));
        return mixed;
    }
};

/// Mean light of `factor` x `factor` pixels.
Plate reduced(const std::vector<std::uint8_t>& rgb, int width, int height, int factor) {
    const calib::Srgb srgb;
    Plate plate{width / factor, height / factor, {}};
    plate.pixels.reserve(static_cast<std::size_t>(plate.width) *
                         static_cast<std::size_t>(plate.height));
    for (int y = 0; y < plate.height; ++y)
        for (int x = 0; x < plate.width; ++x) {
            std::array<double, 3> sum{};
            for (int dy = 0; dy < factor; ++dy)
                for (int dx = 0; dx < factor; ++dx)
                    for (std::size_t c = 0; c < 3; ++c)
                        sum.at(c) +=
                            srgb.light(rgb[3 * (static_cast<std::size_t>(y * factor + dy) *
                                                    static_cast<std::size_t>(width) +
                                                static_cast<std::size_t>(x * factor + dx)) +
                                           c]);
            const double area = static_cast<double>(factor) * factor;
            plate.pixels.push_back({static_cast<float>(sum[0] / area),
                                    static_cast<float>(sum[1] / area),
                                    static_cast<float>(sum[2] / area)});
        }
    return plate;
}

std::vector<float> gaussian(double sigma) {
    std::vector<float> weights;
    const int reach = static_cast<int>(std::ceil(4 * sigma));
    for (int i = -reach; i <= reach; ++i)
        weights.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma))));
    float sum = 0;
    for (const float weight : weights)
        sum += weight;
    for (float& weight : weights)
        weight /= sum;
    return weights;
}

Plate blurred(const Plate& plate, const std::vector<float>& weights, int dx, int dy) {
    Plate out{plate.width, plate.height, {}};
    out.pixels.reserve(plate.pixels.size());
    const int reach = static_cast<int>(weights.size()) / 2;
    for (int y = 0; y < plate.height; ++y)
        for (int x = 0; x < plate.width; ++x) {
            std::array<float, 3> sum{};
            int off = -reach;
            for (const float weight : weights) {
                const auto pixel = plate.at(x + dx * off, y + dy * off);
                for (std::size_t c = 0; c < 3; ++c)
                    sum.at(c) += weight * pixel.at(c);
                ++off;
            }
            out.pixels.push_back(sum);
        }
    return out;
}

} // namespace

PanelCamera::PanelCamera(int width, int height, std::uint32_t seed) : engine_(seed) {
    camera_.intrinsics = {width, height, 0.75 * width, 0.75 * width, width * 0.5, height * 0.5};
    camera_.distortion.k1 = -0.08;
    camera_.distortion.k2 = 0.02;
    camera_.distortion.p1 = 4e-4;
}

void PanelCamera::place(const glm::dvec3& eye, double rollRad) {
    const glm::dvec3 forward = glm::normalize(-eye);
    const glm::dvec3 up(std::sin(rollRad), std::cos(rollRad), 0);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
    const glm::dvec3 down = glm::cross(forward, right);
    const glm::dmat3 displayFromCamera(right, down, forward);
    eye_ = eye;
    sighted_.clear();
    for (int y = 0; y < camera_.intrinsics.height; ++y)
        for (int x = 0; x < camera_.intrinsics.width; ++x) {
            const glm::dvec3 ray(camera_.unproject({x, y}).value(), 1.0);
            const glm::dvec3 way = displayFromCamera * ray;
            sighted_.push_back({glm::dvec2(eye - way * (eye.z / way.z)),
                                static_cast<float>(std::pow(1 / glm::length(ray), 4))});
        }
}

std::vector<std::uint8_t> PanelCamera::photograph(const calib::DisplayOptics& panel,
                                                  const std::vector<std::uint8_t>& rgb) {
    const calib::SubpixelLayout& layout = panel.subpixels;
    const calib::EyePicture seen = calib::look(panel, light, eye_, rgb);
    // Panel pixels that one of the camera's covers.
    const double covered = glm::length(eye_) / camera_.intrinsics.fx / layout.pixelM;
    const int factor = std::max(1, static_cast<int>(covered));
    const Plate sharp = reduced(seen.rgb, layout.width, layout.height, factor);

    const int width = camera_.intrinsics.width, height = camera_.intrinsics.height;
    Plate plate{width, height, {}};
    plate.pixels.reserve(sighted_.size());
    for (const Sighted& sighted : sighted_) {
        const double panelX = sighted.point.x / layout.pixelM + layout.width / 2.0;
        const double panelY = layout.height / 2.0 - sighted.point.y / layout.pixelM;
        auto pixel = sharp.between(panelX / factor - 0.5, panelY / factor - 0.5);
        for (float& channel : pixel)
            channel *= sighted.falloff;
        plate.pixels.push_back(pixel);
    }
    const auto weights = gaussian(defocusPx);
    plate = blurred(blurred(plate, weights, 1, 0), weights, 0, 1);

    const calib::Srgb srgb;
    std::normal_distribution<double> noise;
    std::vector<std::uint8_t> photo;
    photo.reserve(3 * plate.pixels.size());
    for (std::size_t i = 0; i < plate.pixels.size(); ++i)
        for (const float channel : plate.pixels[i]) {
            const double across = static_cast<double>(i % static_cast<std::size_t>(width)) / width;
            const double level = exposure * (channel + roomLight * (1 - 0.5 * across));
            const double sigma = std::hypot(readNoise, shotNoise * std::sqrt(level));
            photo.push_back(srgb.level(level + sigma * noise(engine_)));
        }
    return photo;
}

} // namespace autostereo::test

#pragma once

#include "calib/sensor_rig.hpp"
#include "devices/frame_pool.hpp"
#include "gpu/params.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <utility>

// Depth pictures and cameras that no sensor should deliver, drawn by a seed. Depth is whole counts
// everywhere: NaN and infinity cannot be carried.

namespace autostereo::test {

struct GridSize {
    int width, height;
};
inline constexpr std::array<GridSize, 8> kGridSizes{
    {{1, 1}, {2, 1}, {3, 5}, {176, 144}, {320, 288}, {512, 424}, {640, 480}, {640, 576}}};

/// Count of a pixel, from its column, row and a random number.
struct PixelClass {
    const char* name;
    std::uint32_t (*count)(std::uint32_t x, std::uint32_t y, std::uint32_t random);
};
inline constexpr std::array<PixelClass, 9> kPixelClasses{{
    {"zero", [](auto, auto, auto) { return 0U; }},
    {"65535", [](auto, auto, auto) { return 65535U; }},
    {"1 mm", [](auto, auto, auto) { return 1U; }},
    {"65 m", [](auto, auto, auto) { return 65000U; }},
    {"checkerboard", [](auto x, auto y, auto) { return (x + y) % 2 * 1500U; }},
    {"one pixel", [](auto x, auto y, auto) { return x == 0 && y == 0 ? 900U : 0U; }},
    {"random", [](auto, auto, auto random) { return random & 0xffffU; }},
    {"near and far", [](auto x, auto, auto) { return x / 7 % 2 == 0 ? 1U : 65534U; }},
    {"all classes",
     [](auto, auto, auto random) {
         constexpr std::array<std::uint32_t, 8> kCounts{0, 65535, 1, 65000, 150, 1500, 2200, 65534};
         return kCounts[random % kCounts.size()];
     }},
}};

/// Everything that a case's number decides.
class HostileScene {
  public:
    HostileScene(std::uint64_t number, GridSize size, const PixelClass& pixels)
        : random_(number), size_(size), pixels_(pixels) {
        rig.depth = camera(size.width, size.height);
        rig.color = camera(kColorWidth, kColorHeight);
        const double baseline = uniform(0, 0.5), angle = uniform(0, 6.28);
        rig.colorFromDepth.translation = {baseline * std::cos(angle), baseline * std::sin(angle),
                                          0};
        rig.colorFromDepth.rotation = glm::dmat3(
            glm::rotate(glm::dmat4(1), uniform(-0.2, 0.2), {uniform(-1, 1), uniform(-1, 1), 1}));
        params.mesh.nearestM = std::array{0.01, 0.15, 1.6}[random_() % 3]; // 1.6: inside most
        params.condition.validity = random_() % 2 == 0;
        params.condition.hold = random_() % 2 == 0;
        params.clearColor = {1, 0, 1}; // no colour of the scene's
    }
    HostileScene(const HostileScene&) = delete;
    HostileScene& operator=(const HostileScene&) = delete;

    static constexpr int kColorWidth = 64, kColorHeight = 36;
    static constexpr int kDarkest = 60, kBrightest = 200;

    /// The next frame; every other one is of a class drawn by chance.
    [[nodiscard]] devices::RgbdFrame next() {
        const PixelClass& pixels =
            frames_++ % 2 == 0 ? pixels_ : kPixelClasses[random_() % kPixelClasses.size()];
        devices::RgbdFrame frame;
        frame.depth = *pool_.acquire({devices::PixelFormat::Depth16, size_.width, size_.height});
        frame.color = *pool_.acquire({devices::PixelFormat::Rgba8, kColorWidth, kColorHeight});
        std::size_t at = 0;
        for (std::uint32_t y = 0; y < static_cast<std::uint32_t>(size_.height); ++y)
            for (std::uint32_t x = 0; x < static_cast<std::uint32_t>(size_.width); ++x)
                frame.depth.depth()[at++] = static_cast<std::uint16_t>(
                    pixels.count(x, y, static_cast<std::uint32_t>(random_())));
        for (std::byte& level : frame.color.pixels())
            level = static_cast<std::byte>(kDarkest + random_() % (kBrightest - kDarkest + 1));
        return frame;
    }
    [[nodiscard]] double uniform(double low, double high) {
        return std::uniform_real_distribution(low, high)(random_);
    }
    [[nodiscard]] std::string name() const {
        return std::string(pixels_.name) + " at " + std::to_string(size_.width) + "x" +
               std::to_string(size_.height) + ", depth fx " +
               std::to_string(rig.depth.intrinsics.fx) + ", colour fx " +
               std::to_string(rig.color.intrinsics.fx) + ", nearest " +
               std::to_string(params.mesh.nearestM);
    }

    calib::SensorRig rig;
    gpu::PipelineParams params;

  private:
    /// As far as the lens maps farther rays to farther pixels, at most 63 degrees.
    static double radiusOf(const calib::Distortion& lens) {
        const auto rises = [&](double r2) { return 1 + r2 * (3 * lens.k1 + 5 * lens.k2 * r2) > 0; };
        double radius = 0;
        while (radius < 2 && rises(radius * radius))
            radius += 0.01;
        return radius;
    }

    /// Focal lengths of 1 to 10,000 pixels; every second camera has a distorting lens.
    calib::CameraModel camera(int width, int height) {
        const double focal = std::pow(10, uniform(0, 4));
        calib::CameraModel model;
        model.intrinsics = {width,
                            height,
                            focal,
                            focal * uniform(0.9, 1.1),
                            (width - 1) * uniform(0.4, 0.6),
                            (height - 1) * uniform(0.4, 0.6)};
        if (random_() % 2 == 0) {
            model.distortion.k1 = uniform(-0.3, 0.3);
            model.distortion.k2 = uniform(-0.1, 0.1);
            model.distortion.metricRadius = uniform(0.3, 1) * radiusOf(model.distortion);
        }
        return model;
    }

    std::mt19937_64 random_;
    GridSize size_;
    PixelClass pixels_;
    devices::FramePool pool_{4};
    std::uint64_t frames_ = 0;
};

} // namespace autostereo::test

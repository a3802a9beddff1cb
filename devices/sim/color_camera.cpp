#include "devices/sim/color_camera.hpp"

#include "devices/sim/hash.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace autostereo::devices::sim {
namespace {

constexpr std::size_t kChannels = 4;
constexpr std::size_t kNoiseStarts = 1U << 16; // different rows of noise before one comes again

} // namespace

ColorCamera::Rgba ColorCamera::colorOf(const Hit& hit) {
    // Never negative; lround is a library call, too slow for a million pixels a frame.
    // NOLINTNEXTLINE(bugprone-incorrect-roundings)
    const auto rounded = [](double value) { return static_cast<std::uint8_t>(value + 0.5); };
    return {rounded(hit.color.r), rounded(hit.color.g), rounded(hit.color.b), 255};
}

ColorCamera::ColorCamera(std::shared_ptr<const Scene> scene, const calib::CameraModel& camera,
                         const calib::RigidTransform& sceneFromCamera, std::uint64_t seed,
                         bool noise)
    : scene_(std::move(scene)), intrinsics_(camera.intrinsics), seed_(seed),
      background_(static_cast<std::size_t>(intrinsics_.width) *
                      static_cast<std::size_t>(intrinsics_.height),
                  Rgba{0, 0, 0, 255}),
      view_(*scene_, camera, sceneFromCamera,
            [this](std::size_t pixel, const Hit& hit) { background_[pixel] = colorOf(hit); }) {
    if (noise) makeNoise();
}

void ColorCamera::makeNoise() {
    noise_.resize((kNoiseStarts + static_cast<std::size_t>(intrinsics_.width)) * kChannels);
    for (std::size_t i = 0; i < noise_.size(); ++i) {
        if (i % kChannels == kChannels - 1) continue;
        const double value = kNoiseSigma * static_cast<double>(gaussianFrom(hashBits(seed_, i)));
        noise_[i] = static_cast<std::int8_t>(std::lround(value));
    }
}

FrameMetadata ColorCamera::shape() const noexcept {
    FrameMetadata metadata;
    metadata.format = PixelFormat::Rgba8;
    metadata.width = intrinsics_.width;
    metadata.height = intrinsics_.height;
    return metadata;
}

void ColorCamera::expose(Frame& frame) noexcept {
    const std::span<std::byte> pixels = frame.pixels();
    std::memcpy(pixels.data(), background_.data(), pixels.size());
    view_.drawMoving(secondsOf(frame.metadata().capturedAt),
                     [&](std::size_t pixel, const Hit& hit) {
                         const Rgba color = colorOf(hit);
                         std::memcpy(&pixels[pixel * kChannels], color.data(), kChannels);
                     });
    if (!noise_.empty()) addNoise(frame.metadata().sequence, pixels);
}

void ColorCamera::addNoise(std::uint64_t sequence, std::span<std::byte> pixels) const {
    const std::uint64_t key = hashBits(seed_, sequence);
    const std::size_t rowBytes = static_cast<std::size_t>(intrinsics_.width) * kChannels;
    for (std::size_t row = 0; row * rowBytes < pixels.size(); ++row) {
        std::byte* const values = &pixels[row * rowBytes];
        const std::int8_t* const noise = &noise_[(hashBits(key, row) % kNoiseStarts) * kChannels];
        for (std::size_t i = 0; i < rowBytes; ++i) {
            const int value = std::to_integer<int>(values[i]) + noise[i];
            values[i] = static_cast<std::byte>(std::clamp(value, 0, 255));
        }
    }
}

} // namespace autostereo::devices::sim

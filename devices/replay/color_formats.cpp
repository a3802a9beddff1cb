#include "devices/replay/color_formats.hpp"

#include <algorithm>

namespace autostereo::devices {

namespace {

/// ITU-R BT.601 in 16.16 fixed point.
void putYuv(std::byte luma, std::byte cb, std::byte cr, std::byte* rgba) {
    constexpr int kOne = 1 << 16, kHalf = kOne / 2;
    constexpr int kLuma = 76309;                      // 255 / 219
    constexpr int kRedCr = 104597, kGreenCr = 53279;  // 1.596, 0.813
    constexpr int kGreenCb = 25675, kBlueCb = 132201; // 0.392, 2.017
    const int y = (std::to_integer<int>(luma) - 16) * kLuma + kHalf;
    const int u = std::to_integer<int>(cb) - 128, v = std::to_integer<int>(cr) - 128;
    const auto clip = [](int value) {
        return static_cast<std::byte>(std::clamp(value >> 16, 0, 255));
    };
    rgba[0] = clip(y + kRedCr * v);
    rgba[1] = clip(y - kGreenCr * v - kGreenCb * u);
    rgba[2] = clip(y + kBlueCb * u);
    rgba[3] = std::byte{255};
}

} // namespace

void nv12ToRgba(std::span<const std::byte> from, std::size_t width, std::size_t height,
                std::span<std::byte> to) {
    const auto chroma = from.subspan(width * height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t pair = y / 2 * width + x / 2 * 2;
            putYuv(from[y * width + x], chroma[pair], chroma[pair + 1], &to[(y * width + x) * 4]);
        }
}

void yuy2ToRgba(std::span<const std::byte> from, std::span<std::byte> to) {
    for (std::size_t i = 0; i + 3 < from.size(); i += 4) { // Y0 U Y1 V: two pixels
        putYuv(from[i], from[i + 1], from[i + 3], &to[i * 2]);
        putYuv(from[i + 2], from[i + 1], from[i + 3], &to[i * 2 + 4]);
    }
}

void bgraToRgba(std::span<const std::byte> from, std::span<std::byte> to) {
    for (std::size_t i = 0; i + 3 < from.size(); i += 4) {
        to[i] = from[i + 2];
        to[i + 1] = from[i + 1];
        to[i + 2] = from[i];
        to[i + 3] = std::byte{255};
    }
}

} // namespace autostereo::devices

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace autostereo::devices {

/// Grey16 is host-endian; all are tightly packed, top row first, gamma-encoded as in the file.
enum class ImageFormat : std::uint8_t { Grey8, Rgb8, Rgba8, Grey16 };

[[nodiscard]] constexpr std::size_t bytesPerPixel(ImageFormat format) {
    switch (format) {
    case ImageFormat::Grey8:
        return 1;
    case ImageFormat::Grey16:
        return 2;
    case ImageFormat::Rgb8:
        return 3;
    case ImageFormat::Rgba8:
        break;
    }
    return 4;
}

constexpr int kLargestSide = 16384; ///< pixels; what a texture may measure

/// In pixels; 0x0: not known, or not there.
struct PictureSize {
    int width = 0;
    int height = 0;

    [[nodiscard]] bool operator==(const PictureSize&) const = default;
    [[nodiscard]] std::string text() const {
        return std::to_string(width) + "x" + std::to_string(height);
    }
};

/// Format and size of a picture, known before its pixels are.
struct ImageHeader {
    ImageFormat format = ImageFormat::Rgba8;
    int width = 0;
    int height = 0;

    [[nodiscard]] std::size_t bytes() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
               bytesPerPixel(format);
    }
    [[nodiscard]] bool sizeAllowed() const {
        return width >= 1 && height >= 1 && width <= kLargestSide && height <= kLargestSide;
    }
    [[nodiscard]] PictureSize size() const { return {width, height}; }
};

/// Somebody else's pixels.
struct ImageView {
    ImageHeader header;
    std::span<const std::byte> pixels; ///< header.bytes() of them
};

} // namespace autostereo::devices

#include "devices/replay/grey_image.hpp"

#include "devices/replay/image_files.hpp"

#include <cmath>
#include <cstring>
#include <span>

namespace autostereo::devices {

namespace {

/// Where a format keeps its colours.
struct Channels {
    std::size_t stride, red, green, blue;
};

std::vector<std::uint16_t> lumaOf(std::span<const std::byte> pixels, const Channels& channels) {
    std::vector<std::uint16_t> values(pixels.size() / channels.stride);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto at = [&](std::size_t offset) {
            return std::to_integer<int>(pixels[i * channels.stride + offset]);
        };
        values[i] = static_cast<std::uint16_t>(std::lround(
            0.299 * at(channels.red) + 0.587 * at(channels.green) + 0.114 * at(channels.blue)));
    }
    return values;
}

std::size_t lumaBytes(const FrameMetadata& form) {
    return static_cast<std::size_t>(form.width) * static_cast<std::size_t>(form.height);
}

} // namespace

GreyPixels readGrey(const std::filesystem::path& file) {
    ImageReader reader;
    const ImageHeader header = reader.open(file);
    std::vector<std::byte> pixels(header.bytes());
    reader.decode(pixels);
    GreyPixels grey{header.width, header.height, {}, header.format == ImageFormat::Grey16};
    if (grey.is16Bit) {
        grey.values.resize(pixels.size() / 2);
        std::memcpy(grey.values.data(), pixels.data(), pixels.size());
    } else {
        grey.values = lumaOf(pixels, {4, 0, 1, 2});
    }
    return grey;
}

GreyPixels greyOf(const Frame& frame) {
    GreyPixels grey{frame.metadata().width, frame.metadata().height, {}, false};
    switch (frame.metadata().format) {
    case PixelFormat::Rgba8:
        grey.values = lumaOf(frame.pixels(), {4, 0, 1, 2});
        break;
    case PixelFormat::Bgra8:
        grey.values = lumaOf(frame.pixels(), {4, 2, 1, 0});
        break;
    case PixelFormat::Rgb8:
        grey.values = lumaOf(frame.pixels(), {3, 0, 1, 2});
        break;
    case PixelFormat::Bgr8:
        grey.values = lumaOf(frame.pixels(), {3, 2, 1, 0});
        break;
    case PixelFormat::Grey8:
        grey.values = lumaOf(frame.pixels(), {1, 0, 0, 0});
        break;
    case PixelFormat::Yuyv:
        grey.values = lumaOf(frame.pixels(), {2, 0, 0, 0});
        break;
    case PixelFormat::Uyvy:
        grey.values = lumaOf(frame.pixels(), {2, 1, 1, 1});
        break;
    case PixelFormat::Nv12:
        grey.values = lumaOf(frame.pixels().first(lumaBytes(frame.metadata())), {1, 0, 0, 0});
        break;
    case PixelFormat::Depth16:
        return {};
    }
    return grey;
}

} // namespace autostereo::devices

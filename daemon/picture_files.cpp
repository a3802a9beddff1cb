#include "daemon/picture_files.hpp"

#include "devices/replay/image_files.hpp"
#include "devices/replay/tiff_file.hpp"

namespace autostereo::daemon {

void writePicturePng(const std::filesystem::path& file, const gpu::RgbImage& image) {
    devices::writePng(file, {{devices::ImageFormat::Rgb8, image.width, image.height},
                             std::as_bytes(std::span(image.pixels))});
}

void writeFloatTiff(const std::filesystem::path& file, const gpu::FloatImage& image) {
    devices::writeTiff(file, image.width, image.height, image.values);
}

void writeDepthPng(const std::filesystem::path& file, const gpu::DepthImage& image) {
    devices::writePng(file, {{devices::ImageFormat::Grey16, image.width, image.height},
                             std::as_bytes(std::span(image.millimetres))});
}

std::vector<std::uint8_t> withoutAlpha(std::span<const std::byte> rgba) {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(rgba.size() / 4 * 3);
    for (std::size_t at = 0; at < rgba.size(); at += 4)
        for (std::size_t c = 0; c < 3; ++c)
            rgb.push_back(std::to_integer<std::uint8_t>(rgba[at + c]));
    return rgb;
}

} // namespace autostereo::daemon

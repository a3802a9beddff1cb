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

} // namespace autostereo::daemon

#include "daemon/picture_files.hpp"

#include "devices/replay/image_files.hpp"

namespace autostereo::daemon {

void writePicturePng(const std::filesystem::path& file, const gpu::RgbImage& image) {
    devices::writePng(file, {{devices::ImageFormat::Rgb8, image.width, image.height},
                             std::as_bytes(std::span(image.pixels))});
}

void writeDepthPng(const std::filesystem::path& file, const gpu::DepthImage& image) {
    devices::writePng(file, {{devices::ImageFormat::Grey16, image.width, image.height},
                             std::as_bytes(std::span(image.millimetres))});
}

} // namespace autostereo::daemon

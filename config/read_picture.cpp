#include "config/read_picture.hpp"

#include "devices/replay/image_files.hpp"

#include <span>
#include <stdexcept>

namespace autostereo::config {

calib::Picture readPicture(const std::filesystem::path& file) {
    devices::ImageReader reader;
    const devices::ImageHeader header = reader.open(file);
    if (header.format != devices::ImageFormat::Rgba8)
        throw std::runtime_error(file.string() + ": is 16-bit grey (allowed an 8-bit picture)");
    calib::Picture picture{header.width, header.height, {}};
    picture.pixels.resize(header.bytes());
    reader.decode(std::as_writable_bytes(std::span(picture.pixels)));
    return picture;
}

} // namespace autostereo::config

#include "devices/replay/image_files.hpp"

#include "devices/input.hpp"

#include <fstream>
#include <stdexcept>
#include <system_error>

namespace autostereo::devices {

namespace {

constexpr std::size_t kLargestPicture = 512U << 20U; // bytes of a compressed file

bool startsLikeJpeg(std::span<const std::byte> bytes) {
    return bytes.size() >= 2 && bytes[0] == std::byte{0xff} && bytes[1] == std::byte{0xd8};
}

} // namespace

void readFile(const std::filesystem::path& path, std::size_t limit, std::vector<std::byte>& bytes) {
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    if (error)
        throw DeviceError("cannot read " + path.string() + ": " + error.message(),
                          error == std::errc::no_such_file_or_directory);
    if (size > limit)
        throw DeviceError("cannot read " + path.string() + ": " + std::to_string(size) +
                          " bytes (allowed up to " + std::to_string(limit) + ")");
    bytes.resize(size);
    std::ifstream file(path, std::ios::binary);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (!file) throw DeviceError("cannot read " + path.string() + ": the system gave an error");
}

std::vector<std::byte> readFile(const std::filesystem::path& path, std::size_t limit) {
    std::vector<std::byte> bytes;
    readFile(path, limit, bytes);
    return bytes;
}

ImageHeader ImageReader::open(const std::filesystem::path& path) {
    path_ = path;
    readFile(path, kLargestPicture, file_);
    isPng_ = PngDecoder::recognises(file_);
    if (!isPng_ && !startsLikeJpeg(file_))
        throw std::runtime_error(path.string() + ": is no PNG and no JPEG");
    try {
        return isPng_ ? png_.open(file_) : jpeg_.open(file_);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(path.string() + ": " + error.what());
    }
}

void ImageReader::decode(std::span<std::byte> pixels) try {
    isPng_ ? png_.decode(pixels) : jpeg_.decode(pixels);
} catch (const std::runtime_error& error) {
    throw std::runtime_error(path_.string() + ": " + error.what());
}

} // namespace autostereo::devices

#pragma once

#include "devices/replay/image.hpp"
#include "devices/replay/jpeg_decoder.hpp"
#include "devices/replay/png_decoder.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace autostereo::devices {

/// Reads PNG and JPEG files, told apart by their first bytes, in two steps so that the caller
/// places the pixels: open() gives the size, decode() fills memory of header.bytes(). 16-bit grey
/// comes as Grey16, all else as Rgba8 with 255 as alpha. Keep one per stream: buffers and decoders
/// are reused. Thread-bound; std::runtime_error names file, size and reason.
class ImageReader {
  public:
    [[nodiscard]] ImageHeader open(const std::filesystem::path& path);
    void decode(std::span<std::byte> pixels);

  private:
    std::filesystem::path path_;
    std::vector<std::byte> file_;
    PngDecoder png_;
    JpegDecoder jpeg_;
    bool isPng_ = false;
};

/// Writes top row first, under a temporary name that becomes `path` only when complete.
/// Throws std::runtime_error.
void writePng(const std::filesystem::path& path, const ImageView& image);

/// A PNG file's bytes, top row first. Throws std::runtime_error. Reentrant.
[[nodiscard]] std::string encodePng(const ImageView& image);

/// The whole file, or std::runtime_error (also where it has more than `limit` bytes).
[[nodiscard]] std::vector<std::byte> readFile(const std::filesystem::path& path, std::size_t limit);
/// The same into a buffer that is kept between calls.
void readFile(const std::filesystem::path& path, std::size_t limit, std::vector<std::byte>& bytes);

} // namespace autostereo::devices

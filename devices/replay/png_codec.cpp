#include "devices/replay/image_files.hpp"
#include "devices/replay/png_decoder.hpp"

#include <png.h>

#include <array>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include <unistd.h>

// libpng reports errors by longjmp: the functions below that call setjmp own no C++ objects, and
// those that do own some only look at the result.

namespace autostereo::devices {

namespace {

constexpr std::size_t kHeaderBytes = 33; // signature and IHDR

struct ErrorText {
    std::array<char, 160> text{};
};

void onError(png_structp png, png_const_charp message) {
    auto* error = static_cast<ErrorText*>(png_get_error_ptr(png));
    std::snprintf(error->text.data(), error->text.size(), "%s", message);
    png_longjmp(png, 1);
}

void onWarning(png_structp /*png*/, png_const_charp /*message*/) {} // colour profiles and the like

int bigEndian32(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
    // Sizes above 2^31 are invalid in PNG; any number above the limit will do for the message.
    return value > 0x7FFFFFFFU ? std::numeric_limits<int>::max() : static_cast<int>(value);
}

} // namespace

struct PngDecoder::State {
    png_structp png = nullptr;
    png_infop info = nullptr;
    ErrorText error;
    std::span<const std::byte> bytes;
    std::size_t offset = 0;
    ImageHeader header;
    std::vector<png_bytep> rows;

    ~State() { close(); }
    void close() noexcept { png_destroy_read_struct(&png, &info, nullptr); }

    static void onRead(png_structp png, png_bytep to, std::size_t count) {
        auto* self = static_cast<State*>(png_get_io_ptr(png));
        if (count > self->bytes.size() - self->offset) png_error(png, "the file is cut short");
        std::memcpy(to, self->bytes.data() + self->offset, count);
        self->offset += count;
    }

    bool readHeader() {
        if (setjmp(png_jmpbuf(png)) != 0) return false;
        png_set_read_fn(png, this, &State::onRead);
        png_set_user_limits(png, kLargestSide, kLargestSide);
        png_read_info(png, info);
        if (png_get_bit_depth(png, info) == 16 &&
            png_get_color_type(png, info) == PNG_COLOR_TYPE_GRAY) {
            header.format = ImageFormat::Grey16;
            png_set_swap(png); // every machine we build for is little-endian
        } else {
            header.format = ImageFormat::Rgba8;
            png_set_scale_16(png);
            png_set_expand(png);
            png_set_gray_to_rgb(png);
            png_set_strip_alpha(png);
            png_set_add_alpha(png, 0xFF, PNG_FILLER_AFTER);
        }
        png_set_interlace_handling(png);
        png_read_update_info(png, info);
        return png_get_rowbytes(png, info) ==
               static_cast<std::size_t>(header.width) * bytesPerPixel(header.format);
    }

    bool readPixels() {
        if (setjmp(png_jmpbuf(png)) != 0) return false;
        png_read_image(png, rows.data());
        png_read_end(png, nullptr);
        return true;
    }

    [[noreturn]] void fail() const {
        throw std::runtime_error("PNG " + header.size().text() + ": " + error.text.data());
    }
};

PngDecoder::PngDecoder() : state_(std::make_unique<State>()) {}
PngDecoder::~PngDecoder() = default;

bool PngDecoder::recognises(std::span<const std::byte> bytes) {
    return bytes.size() >= 8 &&
           png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) == 0;
}

ImageHeader PngDecoder::open(std::span<const std::byte> bytes) {
    State& s = *state_;
    s.close();
    s.bytes = bytes;
    s.offset = 0;
    s.header = {};
    if (bytes.size() < kHeaderBytes) throw std::runtime_error("PNG: the file is cut short");
    s.header.width = bigEndian32(bytes, 16);
    s.header.height = bigEndian32(bytes, 20);
    if (!s.header.sizeAllowed())
        throw std::runtime_error("PNG " + s.header.size().text() + " (allowed 1 to 16384)");
    std::snprintf(s.error.text.data(), s.error.text.size(), "unexpected layout");
    s.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &s.error, onError, onWarning);
    if (s.png != nullptr) s.info = png_create_info_struct(s.png);
    if (s.info == nullptr) throw std::bad_alloc();
    if (!s.readHeader()) s.fail();
    return s.header;
}

void PngDecoder::decode(std::span<std::byte> pixels) {
    State& s = *state_;
    if (pixels.size() < s.header.bytes()) throw std::runtime_error("PNG: buffer too small");
    const std::size_t stride =
        static_cast<std::size_t>(s.header.width) * bytesPerPixel(s.header.format);
    s.rows.resize(static_cast<std::size_t>(s.header.height));
    for (std::size_t y = 0; y < s.rows.size(); ++y)
        s.rows[y] = reinterpret_cast<png_bytep>(pixels.data() + y * stride);
    const bool good = s.readPixels();
    if (!good) s.fail();
    s.close();
}

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// The libpng side of a write; owns the structures.
struct PngEncoder {
    png_structp png = nullptr;
    png_infop info = nullptr;
    ErrorText error;

    PngEncoder() {
        png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &error, onError, onWarning);
        if (png != nullptr) info = png_create_info_struct(png);
        if (info == nullptr) {
            png_destroy_write_struct(&png, nullptr);
            throw std::bad_alloc();
        }
    }
    ~PngEncoder() { png_destroy_write_struct(&png, &info); }
    PngEncoder(const PngEncoder&) = delete;
    PngEncoder& operator=(const PngEncoder&) = delete;

    bool write(std::FILE* file, const ImageView& image) {
        constexpr std::array<int, 4> kColorType{PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_RGB,
                                                PNG_COLOR_TYPE_RGBA, PNG_COLOR_TYPE_GRAY};
        if (setjmp(png_jmpbuf(png)) != 0) return false;
        const ImageHeader& h = image.header;
        png_init_io(png, file);
        png_set_IHDR(png, info, static_cast<png_uint_32>(h.width),
                     static_cast<png_uint_32>(h.height), h.format == ImageFormat::Grey16 ? 16 : 8,
                     kColorType[static_cast<std::size_t>(h.format)], PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_compression_level(png, 3); // panels are big: half the time of 6 for 5 % more bytes
        png_write_info(png, info);
        if (h.format == ImageFormat::Grey16) png_set_swap(png);
        const std::size_t stride = static_cast<std::size_t>(h.width) * bytesPerPixel(h.format);
        for (std::size_t y = 0; y < static_cast<std::size_t>(h.height); ++y)
            png_write_row(png, reinterpret_cast<png_const_bytep>(image.pixels.data()) + y * stride);
        png_write_end(png, info);
        return true;
    }
};

} // namespace

std::string encodePng(const ImageView& image) {
    const ImageHeader& h = image.header;
    if (!h.sizeAllowed() || image.pixels.size() < h.bytes())
        throw std::runtime_error("cannot encode a picture of " + h.size().text() + " with " +
                                 std::to_string(image.pixels.size()) + " bytes");
    char* bytes = nullptr;
    std::size_t count = 0;
    File memory(open_memstream(&bytes, &count));
    if (!memory) throw std::bad_alloc();
    PngEncoder encoder;
    const bool good = encoder.write(memory.get(), image) && std::fflush(memory.get()) == 0;
    memory.reset();
    const std::unique_ptr<char, decltype(&std::free)> owned(bytes, &std::free);
    if (!good) throw std::runtime_error("cannot encode a picture of " + h.size().text());
    return {bytes, count};
}

void writePng(const std::filesystem::path& path, const ImageView& image) {
    const ImageHeader& h = image.header;
    if (!h.sizeAllowed() || image.pixels.size() < h.bytes())
        throw std::runtime_error("cannot write " + path.string() + ": picture of " +
                                 h.size().text() + " with " + std::to_string(image.pixels.size()) +
                                 " bytes");
    const std::string temporary = path.string() + "." + std::to_string(::getpid()) + ".part";
    const auto give = [&](const std::string& reason) {
        ::unlink(temporary.c_str());
        throw std::runtime_error("cannot write " + path.string() + ": " + reason);
    };
    File file(std::fopen(temporary.c_str(), "wb"));
    if (!file) give(std::generic_category().message(errno));
    PngEncoder encoder;
    if (!encoder.write(file.get(), image)) give(encoder.error.text.data());
    if (std::fclose(file.release()) != 0) give(std::generic_category().message(errno));
    if (std::rename(temporary.c_str(), path.c_str()) != 0)
        give(std::generic_category().message(errno));
}

} // namespace autostereo::devices

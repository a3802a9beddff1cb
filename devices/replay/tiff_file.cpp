#include "devices/replay/tiff_file.hpp"

#include "devices/replay/image.hpp"
#include "devices/replay/whole_file.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

namespace autostereo::devices {

namespace {

static_assert(std::endian::native == std::endian::little, "bytes are written as they lie");

/// Field types of the format.
enum Type : std::uint16_t { Short = 3, Long = 4, Rational = 5 };

struct Field {
    std::uint16_t tag;
    Type type;
    std::uint32_t value; ///< or where it lies
};
constexpr std::size_t kFieldBytes = 12;

template<class Number>
void put(std::string& bytes, Number number) {
    std::array<char, sizeof(Number)> raw;
    std::memcpy(raw.data(), &number, sizeof(Number));
    bytes.append(raw.data(), raw.size());
}

void putField(std::string& bytes, const Field& field) {
    put(bytes, field.tag);
    put(bytes, static_cast<std::uint16_t>(field.type));
    put(bytes, std::uint32_t{1}); // one value
    put(bytes, field.value);      // a Short's lies in the lower half
}

} // namespace

void writeTiff(const std::filesystem::path& path, int width, int height,
               std::span<const float> samples) {
    const ImageHeader header{ImageFormat::Grey8, width, height};
    if (!header.sizeAllowed() || samples.size() != header.bytes())
        throw std::runtime_error("cannot write " + path.string() + ": picture of " +
                                 header.size().text() + " with " + std::to_string(samples.size()) +
                                 " samples");
    constexpr std::uint32_t kFirstDirectory = 8, kFields = 14;
    constexpr std::uint32_t kResolution = kFirstDirectory + 2 + kFields * kFieldBytes + 4;
    constexpr std::uint32_t kPixels = kResolution + 8;
    const std::array<Field, kFields> fields{{
        {256, Long, static_cast<std::uint32_t>(width)},
        {257, Long, static_cast<std::uint32_t>(height)},
        {258, Short, 32}, // bits a sample
        {259, Short, 1},  // not compressed
        {262, Short, 1},  // 0 is black
        {273, Long, kPixels},
        {274, Short, 1},                                 // top row first
        {277, Short, 1},                                 // samples a pixel
        {278, Long, static_cast<std::uint32_t>(height)}, // rows in the only strip
        {279, Long, static_cast<std::uint32_t>(samples.size_bytes())},
        {282, Rational, kResolution},
        {283, Rational, kResolution},
        {296, Short, 1}, // the resolution has no unit
        {339, Short, 3}, // IEEE floats
    }};
    std::string bytes("II*\0", 4);
    bytes.reserve(kPixels + samples.size_bytes());
    put(bytes, kFirstDirectory);
    put(bytes, static_cast<std::uint16_t>(fields.size()));
    for (const Field& field : fields)
        putField(bytes, field);
    put(bytes, std::uint32_t{0}); // no further directory
    put(bytes, std::uint32_t{1}); // resolution 1/1
    put(bytes, std::uint32_t{1});
    bytes.append(reinterpret_cast<const char*>(samples.data()), samples.size_bytes());
    writeWhole(path, bytes);
}

} // namespace autostereo::devices

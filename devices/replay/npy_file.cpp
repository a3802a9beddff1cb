#include "devices/replay/npy_file.hpp"

#include "devices/replay/image_files.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include <unistd.h>

namespace autostereo::devices {

namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kAlignment = 64;

struct ElementType {
    std::string_view name;
    std::size_t bytes;
};
constexpr std::array kTypes{ElementType{"|u1", 1}, ElementType{"<u2", 2}, ElementType{"<u4", 4},
                            ElementType{"<f4", 4}, ElementType{"<f8", 8}};

std::size_t elementBytes(std::string_view type) {
    for (const ElementType& known : kTypes)
        if (known.name == type) return known.bytes;
    return 0;
}

[[noreturn]] void reject(const std::string& name, const std::string& why) {
    throw std::runtime_error(name + ": not a NumPy array that can be read: " + why);
}

/// The text behind `'key':` in the header's dictionary.
std::string_view valueOf(const std::string& name, std::string_view header, std::string_view key) {
    const auto at = header.find('\'' + std::string(key) + '\'');
    const auto colon = header.find(':', at == std::string_view::npos ? header.size() : at);
    if (colon == std::string_view::npos) reject(name, "its header has no " + std::string(key));
    const auto first = header.find_first_not_of(' ', colon + 1);
    return header.substr(std::min(first, header.size()));
}

std::vector<std::size_t> shapeOf(const std::string& name, std::string_view text) {
    constexpr std::size_t kMostDimensions = 4, kLargest = std::size_t{1} << 32;
    std::vector<std::size_t> shape;
    const auto end = text.find(')');
    if (!text.starts_with('(') || end == std::string_view::npos) reject(name, "its shape");
    for (std::size_t at = 1; at < end; ++at) {
        if (text[at] < '0' || text[at] > '9') continue;
        std::size_t number = 0;
        for (; at < end && text[at] >= '0' && text[at] <= '9'; ++at)
            number = std::min(number * 10 + static_cast<std::size_t>(text[at] - '0'), kLargest);
        shape.push_back(number);
        if (shape.size() > kMostDimensions) reject(name, "more than four dimensions");
    }
    return shape;
}

} // namespace

std::size_t NpyHeader::elements() const {
    std::size_t count = 1;
    for (const std::size_t extent : shape)
        if (__builtin_mul_overflow(count, extent, &count)) return SIZE_MAX;
    return count;
}

std::size_t NpyHeader::bytes() const {
    std::size_t count = 0;
    return __builtin_mul_overflow(elements(), elementBytes(type), &count) ? SIZE_MAX : count;
}

NpyArray parseNpy(const std::string& name, std::span<const std::byte> file) {
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    if (!text.starts_with(kMagic) || text.size() < 12) reject(name, "it does not start like one");
    const bool wide = text[6] >= 2;
    const std::size_t headerAt = wide ? 12 : 10;
    std::size_t length = 0;
    for (std::size_t byte = headerAt; byte-- > 8;)
        length = length << 8 | static_cast<unsigned char>(text[byte]);
    if (length > text.size() - headerAt) reject(name, "its header is cut off");
    const std::string_view header = text.substr(headerAt, length);

    NpyArray array;
    if (!valueOf(name, header, "fortran_order").starts_with("False"))
        reject(name, "it is in Fortran order");
    const std::string_view type = valueOf(name, header, "descr").substr(0, 5);
    array.header.type = type.size() == 5 ? type.substr(1, 3) : type;
    if (elementBytes(array.header.type) == 0)
        reject(name, "its type " + std::string(type) + " (allowed |u1, <u2, <u4, <f4, <f8)");
    array.header.shape = shapeOf(name, valueOf(name, header, "shape"));
    const auto data = file.subspan(headerAt + length);
    if (data.size() != array.header.bytes())
        reject(name, "it holds " + std::to_string(data.size()) + " bytes, its header says " +
                         std::to_string(array.header.bytes()));
    array.data.assign(data.begin(), data.end());
    return array;
}

NpyArray readNpy(const std::filesystem::path& path, std::size_t limit) {
    return parseNpy(path.string(), readFile(path, limit));
}

void writeNpy(const std::filesystem::path& path, const NpyHeader& header,
              std::span<const std::byte> data) {
    std::string shape;
    for (const std::size_t extent : header.shape)
        shape += std::to_string(extent) + ", ";
    std::string dictionary =
        "{'descr': '" + header.type + "', 'fortran_order': False, 'shape': (" + shape + "), }";
    const std::size_t start = kMagic.size() + 4;
    dictionary.resize((start + dictionary.size() + 1 + kAlignment - 1) / kAlignment * kAlignment -
                          start - 1,
                      ' ');
    dictionary += '\n';
    std::string head(kMagic);
    head += {1, 0, static_cast<char>(dictionary.size() & 0xff),
             static_cast<char>(dictionary.size() >> 8)};
    head += dictionary;

    const std::string temporary = path.string() + "." + std::to_string(::getpid()) + ".part";
    std::ofstream out(temporary, std::ios::binary);
    out.write(head.data(), static_cast<std::streamsize>(head.size()));
    out.write(reinterpret_cast<const char*>(data.data()),
              static_cast<std::streamsize>(data.size()));
    out.close();
    std::error_code error;
    if (out) std::filesystem::rename(temporary, path, error);
    if (!out || error) {
        const std::string why = error ? error.message() : std::generic_category().message(errno);
        std::filesystem::remove(temporary, error);
        throw std::runtime_error("cannot write " + path.string() + ": " + why);
    }
}

} // namespace autostereo::devices

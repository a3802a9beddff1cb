#include "devices/mesh/ply_header.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace autostereo::devices::mesh {

namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypes{
    {{"char", PlyType::Int8},
     {"uchar", PlyType::Uint8},
     {"short", PlyType::Int16},
     {"ushort", PlyType::Uint16},
     {"int", PlyType::Int32},
     {"uint", PlyType::Uint32},
     {"float", PlyType::Float32},
     {"double", PlyType::Float64},
     {"int8", PlyType::Int8},
     {"uint8", PlyType::Uint8},
     {"int16", PlyType::Int16},
     {"uint16", PlyType::Uint16},
     {"int32", PlyType::Int32},
     {"uint32", PlyType::Uint32},
     {"float32", PlyType::Float32},
     {"float64", PlyType::Float64}}};

PlyType typeOf(const TextLines& lines, std::string_view word) {
    const auto* const known =
        std::ranges::find(kTypes, word, &std::pair<std::string_view, PlyType>::first);
    if (known == kTypes.end()) lines.fail("property", word, "char to double, int8 to float64");
    return known->second;
}

PlyFormat formatOf(const TextLines& lines, std::string_view word) {
    if (word == "ascii") return PlyFormat::Ascii;
    if (word == "binary_little_endian") return PlyFormat::LittleEndian;
    if (word == "binary_big_endian") return PlyFormat::BigEndian;
    lines.fail("format", word, "ascii, binary_little_endian, binary_big_endian");
}

PlyElement element(TextLines& lines) {
    PlyElement element{std::string(lines.word()), 0, {}};
    const std::string_view text = lines.word();
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), element.count);
    if (text.empty() || error != std::errc{} || end != text.data() + text.size())
        lines.fail("element " + element.name, text, "a count");
    return element;
}

PlyProperty property(TextLines& lines) {
    PlyProperty property;
    std::string_view word = lines.word();
    property.isList = word == "list";
    if (property.isList) {
        property.countType = typeOf(lines, lines.word());
        if (property.countType >= PlyType::Float32)
            lines.fail("property", "list", "a whole number as count");
        word = lines.word();
    }
    property.type = typeOf(lines, word);
    property.name = lines.word();
    return property;
}

} // namespace

std::size_t PlyElement::leastBytes(PlyFormat format) const {
    std::size_t bytes = 0;
    for (const PlyProperty& property : properties) {
        const std::size_t binary = bytesOf(property.isList ? property.countType : property.type);
        bytes += format == PlyFormat::Ascii ? 2 : binary; // a digit and what ends it
    }
    return bytes;
}

PlyHeader readPlyHeader(TextLines& lines) {
    constexpr std::size_t kMost = 256; // elements, and properties of each
    PlyHeader header;
    if (!lines.next() || lines.remainder() != "ply") throw DeviceError("is no PLY file");
    while (lines.next()) {
        const std::string_view key = lines.word();
        if (key == "format") {
            header.format = formatOf(lines, lines.word());
        } else if (key == "element") {
            if (header.elements.size() == kMost) lines.fail("element", "", "256 at most");
            header.elements.push_back(element(lines));
        } else if (key == "property") {
            if (header.elements.empty()) lines.fail("property", "", "after an element");
            auto& properties = header.elements.back().properties;
            if (properties.size() == kMost) lines.fail("property", "", "256 an element");
            properties.push_back(property(lines));
        } else if (key == "end_header") {
            for (const PlyElement& each : header.elements) {
                const std::size_t least = std::max<std::size_t>(1, each.leastBytes(header.format));
                // The last line of a text needs no end.
                if (each.count > (lines.unread().size() + 1) / least)
                    throw DeviceError("element " + each.name + " = '" + std::to_string(each.count) +
                                      "' is more than the file has bytes for");
            }
            return header;
        }
    }
    throw DeviceError("ends within the header");
}

} // namespace autostereo::devices::mesh

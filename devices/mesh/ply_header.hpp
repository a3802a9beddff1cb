#pragma once

#include "devices/mesh/text_lines.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace autostereo::devices::mesh {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };
[[nodiscard]] constexpr std::size_t bytesOf(PlyType type) {
    if (type <= PlyType::Uint8) return 1;
    if (type <= PlyType::Uint16) return 2;
    return type == PlyType::Float64 ? 8 : 4;
}

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    bool isList = false;
    PlyType countType = PlyType::Uint8; ///< of lists
};
struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;

    /// Bytes that one of them takes at least.
    [[nodiscard]] std::size_t leastBytes(PlyFormat format) const;
};
struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
};

/// Reads up to end_header, and refuses counts for which the file has not enough bytes. Throws
/// DeviceError.
[[nodiscard]] PlyHeader readPlyHeader(TextLines& lines);

} // namespace autostereo::devices::mesh

#pragma once

#include "devices/mesh/ply_header.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace autostereo::devices::mesh {

/// The values behind a PLY header, one after the other, as numbers. Throws DeviceError at a
/// premature end and, in text, at what is no number.
class PlyValues {
  public:
    PlyValues(TextLines& lines, PlyFormat format)
        : lines_(lines), format_(format), rest_(lines.unread()) {}

    [[nodiscard]] double next(PlyType type) {
        return format_ == PlyFormat::Ascii ? nextWord() : nextBytes(type);
    }
    /// The count of a list: a whole number for which there can be values.
    [[nodiscard]] std::size_t nextCount(const PlyProperty& list) {
        const double count = next(list.countType);
        const std::size_t each = format_ == PlyFormat::Ascii ? 1 : bytesOf(list.type);
        const std::size_t most = (rest_.size() + 1) / each;
        if (!(count >= 0 && count <= static_cast<double>(most)))
            throw DeviceError("list " + list.name + " = '" + std::to_string(count) +
                              "' is more than the file has bytes for");
        return static_cast<std::size_t>(count);
    }

  private:
    double nextWord() {
        for (;;) {
            if (const auto value = lines_.optionalNumber("value")) return *value;
            if (!lines_.next()) throw DeviceError("ends too early");
        }
    }
    double nextBytes(PlyType type) {
        const std::size_t size = bytesOf(type);
        if (rest_.size() < size) throw DeviceError("ends too early");
        std::array<char, 8> bytes{};
        std::copy_n(rest_.begin(), size, bytes.begin());
        rest_.remove_prefix(size);
        static_assert(std::endian::native == std::endian::little);
        if (format_ == PlyFormat::BigEndian)
            std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        switch (type) {
        case PlyType::Int8:
            return as<std::int8_t>(bytes);
        case PlyType::Uint8:
            return as<std::uint8_t>(bytes);
        case PlyType::Int16:
            return as<std::int16_t>(bytes);
        case PlyType::Uint16:
            return as<std::uint16_t>(bytes);
        case PlyType::Int32:
            return as<std::int32_t>(bytes);
        case PlyType::Uint32:
            return as<std::uint32_t>(bytes);
        case PlyType::Float32:
            return as<float>(bytes);
        case PlyType::Float64:
            break;
        }
        return as<double>(bytes);
    }
    template<class Value>
    static double as(const std::array<char, 8>& bytes) {
        Value value{};
        std::memcpy(&value, bytes.data(), sizeof value);
        return static_cast<double>(value);
    }

    TextLines& lines_;
    PlyFormat format_;
    std::string_view rest_; ///< binary
};

} // namespace autostereo::devices::mesh

#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace autostereo::test::usbip {

using Bytes = std::vector<std::uint8_t>;

/// Little endian, as USB has it.
inline void put8(Bytes& bytes, unsigned value) {
    bytes.push_back(static_cast<std::uint8_t>(value & 0xffU));
}
inline void put16(Bytes& bytes, unsigned value) {
    put8(bytes, value);
    put8(bytes, value >> 8U);
}
inline void put32(Bytes& bytes, std::uint32_t value) {
    put16(bytes, value);
    put16(bytes, value >> 16U);
}
inline void put(Bytes& bytes, std::initializer_list<unsigned> values) {
    for (const unsigned value : values)
        put8(bytes, value);
}
inline void put(Bytes& bytes, const Bytes& more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

} // namespace autostereo::test::usbip

#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace autostereo::test {

/// A datagram as opentrack sends it, byte by byte: centimetres and degrees.
inline std::vector<std::byte> opentrackBytes(const std::array<double, 6>& numbers) {
    std::vector<std::byte> bytes;
    for (const double number : numbers) {
        const auto bits = std::bit_cast<std::uint64_t>(number);
        for (unsigned shift = 0; shift < 64; shift += 8)
            bytes.push_back(static_cast<std::byte>(bits >> shift & 0xffU));
    }
    return bytes;
}

} // namespace autostereo::test

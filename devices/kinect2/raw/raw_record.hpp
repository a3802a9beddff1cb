#pragma once

#include "devices/clock.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace autostereo::devices::kinect2 {

// A recording of what a Kinect v2 sends: eight bytes that name the format, then records one behind
// the other, each with its length and a checksum, little endian. Records are only ever added, so
// that a file ends with a whole one or with a part of one, whatever happened to its writer.

inline constexpr std::array<char, 8> kRawMagic{'A', 'S', 'K', '2', 'R', 'A', 'W', '1'};

enum class RawKind : std::uint32_t {
    Start = 1,       ///< of a unit; its serial number, then the four that follow, then packets
    Firmware = 2,    ///< text
    PhasePage = 3,   ///< as the unit's page 2
    DepthPage = 4,   ///< 3
    ColorPage = 5,   ///< 4
    DepthPacket = 6, ///< one isochronous packet; of several empty ones the first
    ColorPacket = 7, ///< one bulk transfer
};

struct RawHeader {
    std::uint32_t checksum = 0; ///< CRC-32 (IEEE 802.3) of what follows it, payload included
    RawKind kind = RawKind::Start;
    std::uint32_t payloadBytes = 0;
    std::uint32_t intact = 1;   ///< 0: the bus reported an error
    std::int64_t arrivedNs = 0; ///< the recording host's monotonic clock; 0: of an empty packet
};
static_assert(sizeof(RawHeader) == 24);

/// Above any page and any packet.
inline constexpr std::size_t kMostRawPayload = std::size_t{2} << 20U;

struct RawRecord {
    RawHeader header;
    std::vector<std::byte> payload;

    [[nodiscard]] TimePoint arrived() const { return TimePoint(Duration(header.arrivedNs)); }
};

/// Reentrant.
[[nodiscard]] std::uint32_t checksumOf(const RawHeader& header, std::span<const std::byte> payload);

} // namespace autostereo::devices::kinect2

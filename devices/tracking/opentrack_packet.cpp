#include "devices/tracking/opentrack_packet.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace autostereo::devices {

namespace {

double doubleAt(std::span<const std::byte> bytes, std::size_t index) {
    std::uint64_t bits = 0;
    for (std::size_t i = 8; i-- > 0;)
        bits = bits << 8U | std::to_integer<std::uint64_t>(bytes[8 * index + i]);
    return std::bit_cast<double>(bits);
}

} // namespace

std::optional<HeadPose> parseOpentrack(std::span<const std::byte> datagram) {
    constexpr double kMostCm = 1000, kMostDeg = 360;
    constexpr double kMetres = 0.01, kRadians = std::numbers::pi / 180;
    if (datagram.size() != kOpentrackBytes) return std::nullopt;
    for (std::size_t i = 0; i < 6; ++i) // NaN fails the comparison
        if (!(std::abs(doubleAt(datagram, i)) <= (i < 3 ? kMostCm : kMostDeg))) return std::nullopt;
    return HeadPose{
        glm::dvec3{doubleAt(datagram, 0), doubleAt(datagram, 1), doubleAt(datagram, 2)} * kMetres,
        doubleAt(datagram, 3) * kRadians, doubleAt(datagram, 4) * kRadians,
        doubleAt(datagram, 5) * kRadians};
}

} // namespace autostereo::devices

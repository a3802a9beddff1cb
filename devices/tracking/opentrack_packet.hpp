#pragma once

#include "devices/tracking/head_pose.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace autostereo::devices {

/// What opentrack's output "UDP over network" sends: six IEEE doubles, little-endian: x, y, z in
/// centimetres, yaw, pitch, roll in degrees; no time, no number, no checksum. Its own manual: x to
/// the right, y up, z forward (to the panel), counted from where the head was when it was centred;
/// what a user's mapping makes of that, TrackerPose puts right.
constexpr std::size_t kOpentrackBytes = 48;

/// Nothing for another size, for NaN and infinity, and beyond 10 m or one full turn.
[[nodiscard]] std::optional<HeadPose> parseOpentrack(std::span<const std::byte> datagram);

} // namespace autostereo::devices

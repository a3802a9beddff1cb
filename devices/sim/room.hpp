#pragma once

#include "devices/sim/body.hpp"

#include <cstdint>
#include <vector>

namespace autostereo::devices::sim {

/// The room's walls, seen from its inside; metres in the scene's frame (y down).
constexpr double kBackWallZ = 3.2;
constexpr double kFrontWallZ = -1.0;
constexpr double kSideWallX = 2.1; ///< at +-
constexpr double kFloorY = 1.10;
constexpr double kCeilingY = -1.50;

/// Walls, floor and ceiling only, painted `walls`; every ray that starts inside ends on them.
[[nodiscard]] std::vector<Body> emptyRoom(const glm::dvec3& walls, std::uint32_t seed);

/// A living room: pictures, shelf, lamp, and a table with objects from 1.0 to 2.4 m on the right;
/// the left is free for a person at 1.4 m. `seed` varies the textures only.
[[nodiscard]] std::vector<Body> furnishedRoom(std::uint32_t seed);

} // namespace autostereo::devices::sim

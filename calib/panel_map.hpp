#pragma once

#include "calib/band_map.hpp"
#include "calib/view_map.hpp"

#include <variant>

namespace autostereo::calib {

/// How a panel is filled with views: by phase, by lit bands per eye, by whole tiles, or with one
/// picture and its disparity. What the interleaver follows.
using PanelMap = std::variant<ViewMap, BandMap, TileFrame, DepthFrame>;

/// For a panel of the given mode (the profile's own, or the monitor's where it has none). `eyes`
/// (display space, metres) count for tracked displays only.
[[nodiscard]] PanelMap panelMap(const DisplayProfile& display, int width, int height,
                                const std::vector<glm::dvec3>& eyes = {});

/// The one for displays whose phase is the same for every eye; throws std::invalid_argument for
/// the others.
[[nodiscard]] ViewMap makeViewMap(const DisplayProfile& display, int width, int height);

} // namespace autostereo::calib

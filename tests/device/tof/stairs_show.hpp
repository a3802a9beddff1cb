#pragma once

#include "tests/device/tof/kinect2_camera.hpp"

#include <cstddef>

namespace autostereo::test {

inline constexpr std::size_t kExposures = 3;

/// Blocks of 64 x 53 pixels from 0.8 to 3.6 m, light falling with the square of the distance; each
/// exposure's blocks lie otherwise.
[[nodiscard]] LitPoint showedPoint(std::size_t exposure, int x, int y);

/// What the camera shows, at that rate; made once.
[[nodiscard]] Kinect2Show stairsShow(double fps);

} // namespace autostereo::test

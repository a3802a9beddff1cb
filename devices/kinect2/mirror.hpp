#pragma once

#include "calib/sensor_rig.hpp"

#include <cstdint>
#include <span>

namespace autostereo::devices::kinect2 {

/// The camera sends both pictures as a mirror shows them, and its calibration is for such pictures.
/// Here is what turns them round. Reentrant.

/// The cameras that take the pictures the right way round.
[[nodiscard]] calib::SensorRig mirrored(const calib::SensorRig& rig);

/// Reverses every row of packed pixels.
void mirrorRows(std::span<std::uint32_t> pixels, int width);

} // namespace autostereo::devices::kinect2

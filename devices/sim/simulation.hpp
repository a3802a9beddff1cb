#pragma once

#include "calib/sensor_rig.hpp"
#include "devices/input.hpp"
#include "devices/sim/scene.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace autostereo::devices::sim {

/// "room", "person" or "calibration-board"; throws DeviceError naming them for any other name.
/// `seed` varies textures. The scene's frame of reference is the simulated colour camera's.
[[nodiscard]] std::unique_ptr<Scene> makeScene(const std::string& name, std::uint64_t seed);

/// Nominal cameras of the simulation at the asked sizes: a time-of-flight camera whose field is at
/// most 75 x 65 degrees, and a colour camera 80 degrees wide, 40 mm beside it and tilted by 2
/// degrees; each with its own distortion.
[[nodiscard]] calib::SensorRig simulatedRig(int depthWidth, int depthHeight, int colorWidth,
                                            int colorHeight);

/// Opens `sim:NAME?seed=1&fps=30&depth=320x288&color=1280x720&noise=on&frames=N` (the values
/// shown are the defaults; without `frames` it never ends). Depth frames are taken at k / fps,
/// colour frames 4 ms later, and with `color_late_ms=M` stamped M ms after that. Throws DeviceError
/// on an unknown name, key or value.
[[nodiscard]] Input openSimulation(const std::string& uri);

} // namespace autostereo::devices::sim

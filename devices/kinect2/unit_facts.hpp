#pragma once

#include "devices/input.hpp"
#include "devices/kinect2/calibration.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace autostereo::devices::kinect2 {

/// What a unit says of itself when it is started, as it says it.
struct UnitPages {
    std::string serial;
    std::string firmware;
    std::vector<std::byte> phases; ///< page 2
    std::vector<std::byte> depth;  ///< page 3
    std::vector<std::byte> color;  ///< page 4
};

/// The same, understood.
struct UnitFacts {
    UnitPages pages;
    std::string serial;
    std::string firmware;
    PhaseCalibration phases;
    DepthCamera depth;
    ColorCalibration color;
};
/// Throws DeviceError, one line.
[[nodiscard]] UnitFacts parseFacts(UnitPages pages);

/// Fills in what an input says of this unit: description, cameras (`rig` replaces them), period,
/// warnings.
void describe(Input& input, const UnitFacts& facts, const std::optional<calib::SensorRig>& rig);

} // namespace autostereo::devices::kinect2

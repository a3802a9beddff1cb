#pragma once

#include "devices/kinect2/calibration.hpp"
#include "devices/kinect2/depth_packets.hpp"

#include <array>

namespace autostereo::devices::kinect2 {

/// What one row of pixels measures at each frequency.
struct PhaseRow {
    using Line = std::array<float, kWidth>;
    alignas(64) std::array<Line, kFrequencies> turns;      ///< of the modulation, 0 to 1 (included)
    alignas(64) std::array<Line, kFrequencies> amplitudes; ///< counts, made equal by the factors
    /// Largest of the nine samples; kSaturated: overexposed.
    alignas(64) std::array<std::int16_t, kWidth> strongest;
};

/// Unpacks and demodulates one row. Reentrant.
void measurePhases(const RawDepthFrame& frame, const PhaseCalibration& calibration, int row,
                   PhaseRow& result);

} // namespace autostereo::devices::kinect2

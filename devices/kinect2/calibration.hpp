#pragma once

#include "calib/camera_model.hpp"
#include "devices/kinect2/sub_image.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace autostereo::devices::kinect2 {

// A unit's own calibration as it is stored in the camera. Parsers take any bytes, check every size
// and throw DeviceError, one line, where a page cannot be used.

/// Page 2.
struct PhaseCalibration {
    /// Zero-phase offsets of each frequency, rows top first: 65536 to the turn.
    std::array<std::vector<std::uint16_t>, kFrequencies> offsets;
    /// What makes amplitudes of the three frequencies equal, relative to the second.
    std::array<double, kFrequencies> amplitudeFactors{};
    bool ownAmplitudeFactors = false;   ///< the unit's; else those of the reference driver
    std::vector<std::uint32_t> defects; ///< indices of pixels that the factory found bad
    std::string note;                   ///< what was left out of the page and why; empty: nothing
};
[[nodiscard]] PhaseCalibration parsePhasePage(std::span<const std::byte> page);

/// Page 3. The camera's pixel centres are at integers, as everywhere in calib.
struct DepthCamera {
    calib::CameraModel model;
    double zOffsetMm = 0; ///< to be added to depths; taken as millimetres, as page 4's lengths are
};
[[nodiscard]] DepthCamera parseDepthCameraPage(std::span<const std::byte> page);

/// Page 4: where the colour camera sees what the depth camera sees, and what the factory measured.
struct ColorCalibration {
    static constexpr std::size_t kTerms = 10; ///< x3 y3 x2y xy2 x2 y2 xy x y 1
    static constexpr std::size_t kCheckRows = 23, kCheckColumns = 28;
    struct Point {
        float x, y;
    };
    using CheckPoints = std::array<std::array<Point, kCheckColumns>, kCheckRows>;
    using CheckDepths = std::array<std::array<float, kCheckColumns>, kCheckRows>;

    double focal = 0;          ///< pixels of the 1920x1080 picture
    double cx = 0, cy = 0;     ///< likewise
    double nominalDepthMm = 0; ///< where the cubics alone are right
    double displacementMm = 0; ///< of the colour camera along x
    std::array<double, kTerms> xTerms{};
    std::array<double, kTerms> yTerms{};
    CheckPoints irCentroids{};
    CheckPoints colorCentroids{};
    CheckDepths checkDepthsMm{};
};
[[nodiscard]] ColorCalibration parseColorPage(std::span<const std::byte> page);

} // namespace autostereo::devices::kinect2

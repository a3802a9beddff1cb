#pragma once

#include "devices/kinect2/calibration.hpp"
#include "devices/kinect2/depth_packets.hpp"

#include <cstdint>
#include <functional>
#include <random>
#include <span>
#include <vector>

namespace autostereo::test {

using Bytes = std::vector<std::byte>;

/// One Kinect v2 that exists only as numbers, in the form its pages have, and what makes them.
struct Kinect2Unit {
    // Page 3, its own conventions: pixels from the corner of the first one, millimetres.
    float fx = 365.4F, fy = 365.4F, cx = 256.2F, cy = 207.9F;
    float k1 = 0.0905F, k2 = -0.2703F, p1 = 0, p2 = 0, k3 = 0.0961F;
    float zOffsetMm = 0;
    // Page 2.
    std::array<std::vector<std::uint16_t>, 3> offsets;
    std::array<std::uint16_t, 3> multipliers{41, 31, 50};
    std::vector<std::array<std::uint16_t, 2>> defects; ///< row, column
    // Page 4.
    float colorFocal = 1081.37F, colorCx = 959.5F, colorCy = 539.5F;
    float nominalDepthMm = 863, displacementMm = 52;
    std::array<float, 10> xTerms{}, yTerms{};
    devices::kinect2::ColorCalibration::CheckPoints irCentroids{}, colorCentroids{};
    devices::kinect2::ColorCalibration::CheckDepths checkDepthsMm{};
};

/// Offsets that vary over the picture as little as a real unit's, rows half a turn apart.
[[nodiscard]] Kinect2Unit inventedUnit();

[[nodiscard]] Bytes phasePage(const Kinect2Unit& unit);
[[nodiscard]] Bytes depthCameraPage(const Kinect2Unit& unit);
[[nodiscard]] Bytes colorPage(const Kinect2Unit& unit);
[[nodiscard]] Bytes completion(std::uint32_t id, std::uint32_t status = 0);

/// What stands before a pixel.
struct LitPoint {
    double depthMm = 0;   ///< along the axis; 0: nothing comes back
    double amplitude = 0; ///< counts, before the frequencies' different contrasts
};
using LitScene = std::function<LitPoint(int x, int y)>;

/// x/z, y/z of the ray that pixel (x, y) sees, by fixed-point iteration on the lens's formula.
[[nodiscard]] std::array<double, 2> rayOf(const Kinect2Unit& unit, int x, int y);

/// What the sensor sends: the decoder's arithmetic the other way round, in double precision. Light
/// leaves a laser 45 mm beside the lens; `sampleSigma`: gaussian noise of each of the nine samples,
/// counts; then the nearest code of 11 bits.
[[nodiscard]] devices::kinect2::RawDepthFrame expose(const Kinect2Unit& unit, const LitScene& scene,
                                                     double sampleSigma, std::mt19937_64& random);

/// The frame as it goes over the wire, the unused tenth sub-image included: full packets, a short
/// one, an empty one for each sub-image.
[[nodiscard]] std::vector<Bytes> depthPackets(const devices::kinect2::RawDepthFrame& frame);

/// One colour picture as it goes over the wire.
[[nodiscard]] Bytes colorPacket(std::span<const std::byte> jpeg, std::uint32_t sequence,
                                std::uint32_t timestamp);

} // namespace autostereo::test

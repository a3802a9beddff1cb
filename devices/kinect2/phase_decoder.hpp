#pragma once

#include "devices/kinect2/wraps.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace autostereo::devices::kinect2 {

struct DecodeParams {
    PhaseNoise noise;
    double leastConfidence = 0.65; ///< below it a pixel has no depth
    double leastAmplitude = 3;     ///< counts, at each frequency, likewise
    double nearestM = 0.3;         ///< along the ray
    double farthestM = 18.75;      ///< the most that three frequencies tell apart
};

/// The same as the arithmetic uses it: paths in units.
struct DepthLimits {
    float confidence, amplitude, leastPath, mostPath;
};

/// kPixels of each, rows top first.
struct DepthPicture {
    /// Along the optical axis, millimetres; 0: no measurement.
    std::vector<float> depthMm = std::vector<float>(kPixels);
    /// Infrared as the reference driver scales it: 16 times the mean amplitude, at most 65534;
    /// 65535 where overexposed.
    std::vector<std::uint16_t> infrared = std::vector<std::uint16_t>(kPixels);
    /// That the wraps are right, 0 (another is as likely) to 1; also of pixels without depth.
    std::vector<float> confidence = std::vector<float>(kPixels);
};

/// Raw phases to depth for one camera. Reentrant once built: two threads may decode two frames.
/// Light starts at a laser 45 mm beside the lens, comes back to the lens, and its path is what is
/// measured; depth follows from both by exact triangulation.
class PhaseDecoder {
  public:
    PhaseDecoder(PhaseCalibration calibration, const DepthCamera& camera,
                 const DecodeParams& params = {});
    void decode(const RawDepthFrame& frame, DepthPicture& picture) const;

  private:
    void writeRow(int row, const PhaseRow& phases, const ChosenRow& chosen,
                  DepthPicture& picture) const;

    PhaseCalibration calibration_;
    WrapFinder wraps_;
    DepthLimits limits_;
    float zOffsetMm_;
    std::vector<float> stretch_;  ///< of each pixel's ray: its length where z is 1
    std::vector<float> sideways_; ///< x/z of each pixel's ray
};

} // namespace autostereo::devices::kinect2

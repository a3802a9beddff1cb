#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

namespace autostereo::calib {

/// Standard deviation of one depth measurement of a time-of-flight camera: a floor (jitter of the
/// modulation) and shot noise, which goes with 1 / amplitude. Where the camera gives no amplitude,
/// shot noise of surfaces alike: with range squared.
struct DepthNoise {
    double floorM = 0.0018;
    double shotM = 3.1;          ///< metres * amplitude counts
    double growthPerM = 0.00125; ///< metres per square metre of range

    [[nodiscard]] double sigmaAtRangeM(double z) const {
        return std::hypot(floorM, growthPerM * z * z);
    }
    [[nodiscard]] double sigmaAtAmplitudeM(double amplitude) const {
        return std::hypot(floorM, shotM / std::fmax(amplitude, 1.0));
    }
};

/// One depth picture of a scene in which nothing moves, counts (0, 65535: no measurement), and its
/// amplitudes, empty where the camera has none.
struct StillFrame {
    std::span<const std::uint16_t> depth;
    std::span<const std::uint16_t> amplitude;
};

struct NoiseFit {
    DepthNoise noise;
    /// Weighted rms over the bins of (measured - fitted) / fitted sigma; none: the pictures do not
    /// support that half of the model (too few pixels, or all at one range or amplitude), which
    /// keeps its default.
    std::optional<double> amplitudeResidual;
    std::optional<double> rangeResidual;
};

/// The noise seen in still frames of one size, at least three. Differences of a pixel two frames
/// apart, because sensors leave part of a frame's noise in the next one; their median per bin of
/// amplitude and of range, which edges and moving specks cannot pull; least squares over the bins.
/// None where neither half can be measured.
[[nodiscard]] std::optional<NoiseFit> measureDepthNoise(std::span<const StillFrame> frames,
                                                        double depthUnitM);

} // namespace autostereo::calib

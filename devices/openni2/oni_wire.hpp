#pragma once

#include <cstdint>

// What the reader process writes to its standard output: one OniStreamHeader, then for each frame
// an OniFrameHeader and its pixels, with the amplitudes behind them where it says so. Instead of it
// all, where there is no such stream: one line that says why.

namespace autostereo::devices::openni2 {

struct OniStreamHeader {
    static constexpr std::uint32_t kMagic = 0x31494e4f; // ONI1
    std::uint32_t magic = kMagic;
    std::int32_t format = 0; ///< PixelFormat
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::int32_t fps = 0;
    std::int32_t frames = 0; ///< in the file
    double depthUnitM = 0.001;
    double horizontalFov = 0; ///< radians, 0: not said
    double verticalFov = 0;
};

struct OniFrameHeader {
    static constexpr std::uint32_t kMagic = 0x454d4152; // RAME
    std::uint32_t magic = kMagic;
    std::uint32_t hasAmplitude = 0;
    std::int64_t capturedAtNs = 0; ///< media time
};

} // namespace autostereo::devices::openni2

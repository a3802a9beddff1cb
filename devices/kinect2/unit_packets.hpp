#pragma once

#include "devices/kinect2/color_packets.hpp"
#include "devices/kinect2/depth_packets.hpp"
#include "devices/kinect2/unit_clock.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace autostereo::devices::kinect2 {

struct TimedDepth {
    RawDepthFrame frame;
    TimePoint capturedAt{};
};
struct TimedColor {
    std::vector<std::byte> jpeg; ///< mirrored, as the camera sends it
    std::uint32_t sequence = 0;
    TimePoint capturedAt{};
};

/// Both streams' packets put together and tied to the host's clock, whether they come off a bus or
/// out of a recording. `arrived` matters where a packet completes something. Thread-bound.
class UnitPackets {
  public:
    struct Counters {
        DepthPackets::Counters depth;
        ColorPackets::Counters color;
    };

    /// One packet in order; `intact`: the bus reports no error. True: `next` is a whole frame, and
    /// its memory before serves for the one to come.
    [[nodiscard]] bool depth(std::span<const std::byte> packet, bool intact, TimePoint arrived,
                             TimedDepth& next);
    [[nodiscard]] bool color(std::span<const std::byte> packet, bool intact, TimePoint arrived,
                             TimedColor& next);
    [[nodiscard]] Counters counters() const {
        return {depthPackets_.counters(), colorPackets_.counters()};
    }

  private:
    UnitClock clock_;
    DepthPackets depthPackets_;
    ColorPackets colorPackets_;
};

} // namespace autostereo::devices::kinect2

#pragma once

#include "devices/clock.hpp"
#include "devices/kinect2/unit_facts.hpp"

#include <cstddef>
#include <span>

namespace autostereo::devices::kinect2 {

/// Hears what a unit sends, below the decoder, on the thread at the bus: nothing may wait there.
class RawTap {
  public:
    virtual ~RawTap() = default;
    /// A unit starts, again or for the first time, and what is half read is forgotten.
    virtual void start(const UnitPages& pages, TimePoint time) = 0;
    /// As `UnitPackets` gets them.
    virtual void depth(std::span<const std::byte> packet, bool intact, TimePoint arrived) = 0;
    virtual void color(std::span<const std::byte> packet, bool intact, TimePoint arrived) = 0;
};

} // namespace autostereo::devices::kinect2

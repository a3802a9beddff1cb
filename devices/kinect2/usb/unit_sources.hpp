#pragma once

#include "devices/kinect2/unit_frames.hpp"
#include "devices/kinect2/usb/unit.hpp"
#include "devices/source.hpp"

#include <memory>

namespace autostereo::devices::kinect2 {

/// Depth of a running camera. Frames that did not come whole are counted as damaged. Thread-bound,
/// and so is the decoding.
class DepthSource final : public Source {
  public:
    DepthSource(std::shared_ptr<Unit> unit, std::shared_ptr<UnitContinuity> continuity);

    [[nodiscard]] ReadResult read(TimePoint deadline) noexcept override;
    [[nodiscard]] bool rewind() noexcept override { return false; }
    [[nodiscard]] SourceCounters counters() const noexcept override;
    [[nodiscard]] Unit::Counters unitCounters() const { return unit_->counters(); }

  private:
    std::shared_ptr<Unit> unit_;
    DepthFrames frames_;
    TimedDepth raw_;
};

/// Its colour. Thread-bound.
class ColorSource final : public Source {
  public:
    ColorSource(std::shared_ptr<Unit> unit, std::shared_ptr<UnitContinuity> continuity);

    [[nodiscard]] ReadResult read(TimePoint deadline) noexcept override;
    [[nodiscard]] bool rewind() noexcept override { return false; }
    [[nodiscard]] SourceCounters counters() const noexcept override;

  private:
    std::shared_ptr<Unit> unit_;
    ColorFrames frames_;
    TimedColor raw_;
};

} // namespace autostereo::devices::kinect2

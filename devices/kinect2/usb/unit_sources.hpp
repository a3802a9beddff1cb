#pragma once

#include "devices/frame_pool.hpp"
#include "devices/kinect2/phase_decoder.hpp"
#include "devices/kinect2/usb/unit.hpp"
#include "devices/replay/jpeg_decoder.hpp"
#include "devices/sequence_counter.hpp"
#include "devices/source.hpp"

#include <memory>
#include <optional>

namespace autostereo::devices::kinect2 {

/// Depth reaches 18.75 m; of steps that 16 bits can count so far the next round one.
inline constexpr double kDepthUnitM = 0.0003;

/// What outlives a camera that goes away and comes back: its calibration, the numbers of its
/// frames.
struct UnitContinuity {
    std::shared_ptr<const PhaseDecoder> decoder; ///< takes a tenth of a second to make
    std::uint64_t nextDepth = 0;
    std::uint64_t nextColor = 0;
};

/// Decoded depth with infrared as amplitude, columns the right way round. Frames that did not come
/// whole are counted as damaged. Thread-bound, and so is the decoding.
class DepthSource final : public Source {
  public:
    DepthSource(std::shared_ptr<Unit> unit, std::shared_ptr<UnitContinuity> continuity);

    [[nodiscard]] ReadResult read(TimePoint deadline) noexcept override;
    [[nodiscard]] bool rewind() noexcept override { return false; }
    [[nodiscard]] SourceCounters counters() const noexcept override;
    [[nodiscard]] Unit::Counters unitCounters() const { return unit_->counters(); }

  private:
    [[nodiscard]] std::optional<Frame> convert();

    std::shared_ptr<Unit> unit_;
    std::shared_ptr<UnitContinuity> continuity_;
    FramePool pool_{kFramesOnTheWay};
    SequenceCounter sequence_;
    TimedDepth raw_;
    DepthPicture picture_;
    SourceCounters counters_;
};

/// Decoded colour, columns the right way round; its JPEG travels with it as it was sent.
/// Thread-bound.
class ColorSource final : public Source {
  public:
    ColorSource(std::shared_ptr<Unit> unit, std::shared_ptr<UnitContinuity> continuity);

    [[nodiscard]] ReadResult read(TimePoint deadline) noexcept override;
    [[nodiscard]] bool rewind() noexcept override { return false; }
    [[nodiscard]] SourceCounters counters() const noexcept override;

  private:
    [[nodiscard]] std::optional<Frame> convert();

    std::shared_ptr<Unit> unit_;
    std::shared_ptr<UnitContinuity> continuity_;
    JpegDecoder jpeg_;
    FramePool pool_{kFramesOnTheWay};
    SequenceCounter sequence_;
    TimedColor raw_;
    SourceCounters counters_;
};

} // namespace autostereo::devices::kinect2

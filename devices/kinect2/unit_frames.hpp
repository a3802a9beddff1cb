#pragma once

#include "devices/frame_pool.hpp"
#include "devices/kinect2/phase_decoder.hpp"
#include "devices/kinect2/unit_facts.hpp"
#include "devices/kinect2/unit_packets.hpp"
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

/// Decoded depth with infrared as amplitude, columns the right way round. Thread-bound.
class DepthFrames {
  public:
    /// Makes the decoder where there is none yet.
    DepthFrames(std::shared_ptr<UnitContinuity> continuity, const UnitFacts& facts);
    /// Nothing: it is counted why.
    [[nodiscard]] std::optional<Frame> convert(const TimedDepth& raw);
    [[nodiscard]] const SourceCounters& counters() const { return counters_; }

  private:
    std::shared_ptr<UnitContinuity> continuity_;
    FramePool pool_{kFramesOnTheWay};
    SequenceCounter sequence_;
    DepthPicture picture_;
    SourceCounters counters_;
};

/// Decoded colour, columns the right way round; its JPEG travels with it as it was sent.
/// Thread-bound.
class ColorFrames {
  public:
    explicit ColorFrames(std::shared_ptr<UnitContinuity> continuity);
    [[nodiscard]] std::optional<Frame> convert(const TimedColor& raw);
    [[nodiscard]] const SourceCounters& counters() const { return counters_; }

  private:
    std::shared_ptr<UnitContinuity> continuity_;
    JpegDecoder jpeg_;
    FramePool pool_{kFramesOnTheWay};
    SequenceCounter sequence_;
    SourceCounters counters_;
};

} // namespace autostereo::devices::kinect2

#pragma once

#include "devices/frame_pool.hpp"
#include "devices/replay/calibration_files.hpp"
#include "devices/source.hpp"

#include <optional>

namespace autostereo::devices {

/// What every recorded stream does alike: lease slots, refuse pictures of another size than the
/// stream has, count. Thread-bound to its source.
class RecordedStream {
  public:
    /// `size` 0x0: the first picture decides.
    RecordedStream(PixelFormat format, PictureSize size, double depthUnitM = 0.001);

    /// A slot for picture `sequence`; nothing where the size is wrong (damaged) or all slots are
    /// in use (starved).
    [[nodiscard]] std::optional<Frame> slot(PictureSize size, std::uint64_t sequence,
                                            TimePoint capturedAt, bool amplitude = false,
                                            std::size_t encodedBytes = 0);
    void countDamaged(std::uint64_t pictures = 1) { counters_.damaged += pictures; }
    [[nodiscard]] ReadResult deliver(Frame&& frame);
    [[nodiscard]] SourceCounters counters() const { return counters_; }

  private:
    FramePool pool_{kFramesOnTheWay};
    PixelFormat format_;
    PictureSize size_;
    double depthUnitM_;
    SourceCounters counters_;
};

} // namespace autostereo::devices

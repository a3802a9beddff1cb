#pragma once

#include "devices/frame_pool.hpp"
#include "devices/sim/simulated_camera.hpp"
#include "devices/source.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace autostereo::devices::sim {

/// When frames are taken: number k at k / fps + offset after zero, the middle of its exposure.
struct FrameTiming {
    double fps = 30;
    Duration offset{0};
    std::optional<std::uint64_t> frames; ///< then Ended; none: for ever
    Duration stampedLate{0};             ///< a clock that is off

    [[nodiscard]] TimePoint at(std::uint64_t frame) const;
};

/// One simulated stream. Never waits: the reader sets the pace. With no free slot in its pool
/// the frame is lost, counted as starved, and `read` says Timeout. Thread-bound.
class SimulatedSource final : public Source {
  public:
    SimulatedSource(std::unique_ptr<SimulatedCamera> camera, const FrameTiming& timing);

    [[nodiscard]] ReadResult read(TimePoint deadline) noexcept override;
    [[nodiscard]] bool rewind() noexcept override;
    [[nodiscard]] SourceCounters counters() const noexcept override { return counters_; }

  private:
    std::unique_ptr<SimulatedCamera> camera_;
    FrameTiming timing_;
    FramePool pool_{kFramesOnTheWay};
    std::uint64_t next_ = 0;
    SourceCounters counters_;
};

} // namespace autostereo::devices::sim

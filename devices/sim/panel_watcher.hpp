#pragma once

#include "calib/picture.hpp"
#include "devices/frame_pool.hpp"
#include "devices/source.hpp"

#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace autostereo::devices::sim {

/// A camera that sees a panel askew, out of focus and with noise (sigma 2 of 255, some light of the
/// room), while the panel lights up `delay` after each swap.
struct WatchedPanel {
    Duration delay = std::chrono::milliseconds(20);
    Duration exposure = std::chrono::milliseconds(8);
    Duration transfer = std::chrono::milliseconds(10); ///< from the exposure's end
    double fps = 30;
    std::uint64_t seed = 1;
};

/// `sim[:panel][?delay_ms=20&exposure_ms=8&transfer_ms=10&fps=30&seed=1]`. Throws AddressError.
[[nodiscard]] WatchedPanel watchedPanel(const std::string& address);

/// Rgba8 frames, 320x240, 30 a second or as told, on the clock. `read` is one thread's, `shown` may
/// be another's.
class PanelWatcher final : public Source {
  public:
    static constexpr int kWidth = 320, kHeight = 240;

    PanelWatcher(const WatchedPanel& panel, Clock& clock);

    /// Swaps: the panel shows this now, which is the time returned, and is seen to after its delay.
    TimePoint shown(const calib::Picture& panel);

    [[nodiscard]] ReadResult read(TimePoint deadline) noexcept override;
    [[nodiscard]] bool rewind() noexcept override { return false; }
    [[nodiscard]] SourceCounters counters() const noexcept override { return counters_; }

  private:
    using Levels = std::vector<float>; ///< by pixel, 0 to 255
    struct Seen {
        TimePoint from;
        Levels levels;
    };
    [[nodiscard]] Levels seenOf(const calib::Picture& panel) const;
    [[nodiscard]] Levels exposed(TimePoint begin, TimePoint end);

    WatchedPanel panel_;
    Clock& clock_;
    std::vector<glm::vec2> places_; ///< of the panel, kTaps for each pixel
    TimePoint startedAt_;
    std::uint64_t next_ = 0;
    FramePool pool_{kFramesOnTheWay};
    SourceCounters counters_;
    std::mutex mutex_;
    std::deque<Seen> seen_; ///< by time, the first since before the last exposure
};

} // namespace autostereo::devices::sim

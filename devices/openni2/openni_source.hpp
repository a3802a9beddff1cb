#pragma once

#include "devices/clock_map.hpp"
#include "devices/frame_pool.hpp"
#include "devices/openni2/openni_device.hpp"
#include "devices/source.hpp"

#include <optional>

namespace autostereo::devices::openni2 {

/// Depth with the infrared taken with it as amplitude, or colour, of an OpenNI2 device. Pictures of
/// another shape than agreed are damaged. Lost when the library says so, or after three seconds
/// without a picture, for which it has no word. Thread-bound.
class OpenNiSource final : public Source {
  public:
    /// Owns its opening of the device; `main` is what it delivers, Depth or Color.
    OpenNiSource(std::unique_ptr<Device> device, Sensor main);

    [[nodiscard]] ReadResult read(TimePoint deadline) noexcept override;
    [[nodiscard]] bool rewind() noexcept override { return false; }
    [[nodiscard]] SourceCounters counters() const noexcept override { return counters_; }
    [[nodiscard]] const Device& device() const { return *device_; }

  private:
    [[nodiscard]] std::optional<Frame> take(Picture picture, TimePoint arrived);
    [[nodiscard]] std::optional<Frame> takeMain(const Picture& picture, TimePoint arrived);
    /// Below, at or above 0: taken before, with or after what waits. By number; in recordings,
    /// which number and time each stream from its own first picture on, by time: the first infrared
    /// belongs to the depth before it, or the first depth to the infrared before it.
    [[nodiscard]] int order(const Picture& picture);
    [[nodiscard]] std::optional<Frame> withInfrared(const Picture& picture);

    SteadyClock clock_;
    std::unique_ptr<Device> device_;
    Sensor main_;
    bool infrared_; ///< each depth frame waits for its infrared
    FramePool pool_{kFramesOnTheWay};
    ClockMap map_;
    TimePoint lastArrival_;
    int lastIndex_ = 0;
    std::uint64_t sequence_ = 0;
    Frame waiting_; ///< depth without its infrared
    int waitingIndex_ = 0;
    Duration waitingAt_{0};
    std::optional<Duration> shift_;    ///< of a recording's infrared stamps to those of depth
    std::optional<Picture> unmatched_; ///< infrared without its depth
    int misses_ = 0;                   ///< depth frames in a row that got none
    SourceCounters counters_;
};

} // namespace autostereo::devices::openni2

#pragma once

#include "calib/sensor_rig.hpp"
#include "devices/frame.hpp"
#include "devices/frame_queue.hpp"
#include "devices/tracking/eye_source.hpp"
#include "devices/tracking/face_finder.hpp"
#include "devices/tracking/params.hpp"

#include <atomic>
#include <optional>
#include <vector>

namespace autostereo::devices {

/// From a camera's pictures to where the viewer's eyes are in display space: pupils (FaceFinder),
/// distance from the depth camera where there is a depth picture with a face in it, else from the
/// eyes' spacing. While nobody has been there for a second it looks five times a second only.
/// One thread tracks, one takes; the counters may be read on any.
class FaceTracker {
  public:
    /// Throws DeviceError where the cascades are not installed.
    explicit FaceTracker(const ViewerParams& params);

    /// `color` is the rig's colour camera's, of any size; `depth` may be empty.
    void track(const Frame& color, const Frame& depth, const calib::SensorRig& rig);
    /// A picture that there was no time for.
    void leaveOut();

    /// The oldest sample that was not taken yet.
    [[nodiscard]] std::optional<EyeSample> take() { return queue_.take(); }
    [[nodiscard]] EyeCounters counters() const noexcept;

  private:
    [[nodiscard]] bool rests(TimePoint now) const;
    [[nodiscard]] std::optional<calib::EyePair> eyes(const Frame& color, const Frame& depth,
                                                     const calib::SensorRig& rig);

    FrameQueue<EyeSample, 64> queue_; // first: aligned
    ViewerParams params_;
    FaceFinder finder_;
    std::vector<std::uint8_t> grey_;
    std::optional<TimePoint> seenAt_, searchedAt_; ///< seen: or begun
    std::atomic<std::uint64_t> received_{0}, accepted_{0}, damaged_{0}, limited_{0}, nobody_{0};
};

} // namespace autostereo::devices

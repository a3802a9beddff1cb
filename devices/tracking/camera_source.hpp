#pragma once

#include "devices/doorbell.hpp"
#include "devices/input.hpp"
#include "devices/source_thread.hpp"
#include "devices/tracking/face_tracker.hpp"

#include <optional>
#include <thread>

namespace autostereo::devices {

/// The viewer as a colour camera of their own sees them. One thread reads the camera (SourceThread,
/// which opens it again when it goes away), another looks for the face in its newest picture: of
/// 640x480 10 ms once it is found, 50 ms while it is not. Recordings repeat, at their own speed.
class CameraSource final : public EyeSource {
  public:
    /// `input` has colour, else DeviceError; its camera is params.camera, else the one of
    /// params.fieldOfViewRad, else its own. `clock` must outlive it.
    CameraSource(const ViewerParams& params, Input input, Clock& clock);

    [[nodiscard]] std::optional<EyeSample> next(TimePoint /*now*/) override {
        return tracker_.take();
    }
    [[nodiscard]] bool isLive() const noexcept override { return true; }
    /// Received: pictures.
    [[nodiscard]] EyeCounters counters() const noexcept override { return tracker_.counters(); }

  private:
    void run(const std::stop_token& stop);
    void lookAtNewest();
    [[nodiscard]] calib::CameraModel cameraOf(const Frame& picture) const;

    ViewerParams params_;
    std::optional<calib::CameraModel> own_; ///< the input's
    FaceTracker tracker_;
    FrameQueue<Frame> pictures_;
    Doorbell bell_;
    // Last, so that the threads end before what they use.
    std::optional<SourceThread> camera_;
    std::jthread finder_;
};

} // namespace autostereo::devices

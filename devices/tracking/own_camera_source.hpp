#pragma once

#include "devices/frame_pool.hpp"
#include "devices/latest.hpp"
#include "devices/tracking/face_tracker.hpp"

#include <atomic>
#include <memory>
#include <thread>

namespace autostereo::devices {

/// The viewer as the daemon's own colour camera sees them, at the distance that its depth camera
/// measures where that sees the face. No device is opened: pairs are handed in and copied, and a
/// thread looks for the face; what comes while it is busy is left out. Hurried recordings are
/// looked at in line instead, every picture, so that each run is the same.
class OwnCameraSource final : public EyeSource {
  public:
    OwnCameraSource(const ViewerParams& params, bool hurried);
    ~OwnCameraSource() override;
    OwnCameraSource(const OwnCameraSource&) = delete;
    OwnCameraSource& operator=(const OwnCameraSource&) = delete;

    void useCameras(const calib::SensorRig& rig) override;
    void saw(const RgbdFrame& frame) override;
    [[nodiscard]] std::optional<EyeSample> next(TimePoint now) override;
    /// As live as the frames that are handed in: hurried recordings may be followed.
    [[nodiscard]] bool isLive() const noexcept override { return false; }
    /// Received: pictures.
    [[nodiscard]] EyeCounters counters() const noexcept override { return tracker_.counters(); }

  private:
    struct Shot {
        Frame color, depth;
        std::shared_ptr<const calib::SensorRig> rig;
    };
    void run(const std::stop_token& stop);

    FaceTracker tracker_;
    bool hurried_;
    std::shared_ptr<const calib::SensorRig> rig_;
    FramePool pool_{8}; ///< two frames each here, on their way and there
    Latest<Shot> latest_;
    std::atomic<bool> busy_{false};
    std::optional<EyeSample> waiting_;
    std::jthread thread_; // last: it uses all of the above
};

} // namespace autostereo::devices

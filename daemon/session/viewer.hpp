#pragma once

#include "calib/display_profile.hpp"
#include "calib/eye_pair.hpp"
#include "devices/tracking/eye_follower.hpp"
#include "devices/tracking/eye_source.hpp"

#include <memory>
#include <optional>
#include <string>

namespace autostereo::daemon {

/// Where the followed viewer is, and what came of the tracker.
struct ViewerStatus {
    std::string source;
    bool tracked = false;
    std::optional<devices::TimePoint> lastSample;
    devices::EyeCounters samples;
    std::uint64_t disordered = 0; ///< of the accepted ones
    calib::EyePair eyes;          ///< that the panel was filled for last
};

/// The viewer whose eyes the panel follows: a tracker and what is made of its samples.
/// Thread-bound.
class Viewer {
  public:
    /// None where nobody is followed, or by a display that knows no eyes, which the log says.
    /// Recorded viewers begin at `start`, or with the recordings at --speed max (none). `clock`
    /// must outlive it. Throws DeviceError.
    [[nodiscard]] static std::unique_ptr<Viewer> open(const devices::ViewerParams& params,
                                                      const calib::DisplayProfile& display,
                                                      std::optional<devices::TimePoint> start,
                                                      devices::Clock& clock);

    /// The eyes when what is drawn now is seen.
    [[nodiscard]] const calib::EyePair& eyes(devices::TimePoint now);
    /// The cameras that `saw` gets frames of.
    void start(const calib::SensorRig& rig) { source_->useCameras(rig); }
    void saw(const devices::RgbdFrame& frame) { source_->saw(frame); }
    [[nodiscard]] bool isLive() const { return source_->isLive(); }
    [[nodiscard]] ViewerStatus status(devices::TimePoint now) const;

  private:
    Viewer(const devices::ViewerParams& params, const calib::DisplayProfile& display,
           std::optional<devices::TimePoint> start, devices::Clock& clock);

    std::string sourceName_;
    calib::EyePair eyes_;
    std::unique_ptr<devices::EyeSource> source_;
    devices::EyeFollower follower_;
};

} // namespace autostereo::daemon

#pragma once

#include "config/config.hpp"
#include "daemon/session/show_policy.hpp"
#include "devices/frame.hpp"

#include <ctime>
#include <optional>

namespace autostereo::daemon {

/// Whether there is anybody to show anything to: opening hours, and who stands before the depth
/// camera. Pure: times only as arguments. Thread-bound.
class Attendance {
  public:
    Attendance(const config::RestParams& params, devices::TimePoint start)
        : params_(params), someone_(start) {}

    void replace(const config::RestParams& params) { params_ = params; }
    /// A depth frame came.
    void saw(const devices::Frame& depth, devices::TimePoint now);
    /// Closed, Nobody, or nothing where pictures are wanted. `local`: what the clock on the wall
    /// says.
    [[nodiscard]] std::optional<Shown> rest(devices::TimePoint now, const std::tm& local) const;

  private:
    [[nodiscard]] bool isSomeone(const devices::Frame& depth) const;

    config::RestParams params_;
    devices::TimePoint someone_;                ///< was last seen, or might have been
    std::optional<devices::TimePoint> watched_; ///< the last depth frame
};

/// The wall clock's local time.
[[nodiscard]] std::tm localTime();

} // namespace autostereo::daemon

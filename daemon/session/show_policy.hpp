#pragma once

#include "config/config.hpp"
#include "devices/feed.hpp"

#include <optional>
#include <string>

namespace autostereo::daemon {

/// What the panel shows.
enum class Shown {
    Starting, ///< nothing yet, for a short time
    Live,
    Frozen,     ///< the last picture: nothing newer came
    ColorAlone, ///< the colour camera's picture, flat: there is no depth
    Idle,       ///< an idle picture with a message
    Nobody,     ///< an idle picture without: nobody is there
    Closed      ///< black: outside of the opening hours
};
/// A picture that stands, whatever the cameras see.
[[nodiscard]] constexpr bool isStanding(Shown shown) { return shown >= Shown::Idle; }
[[nodiscard]] const char* shownName(Shown shown);

/// Decides what is shown, from when pictures came and how the sensors are: live, then frozen for a
/// short time, then what is left. Pure: the time only as an argument. Reentrant.
class ShowPolicy {
  public:
    ShowPolicy(const config::IdleParams& params, devices::TimePoint start)
        : params_(params), start_(start) {}

    /// Texts and times of another configuration.
    void replace(const config::IdleParams& params) { params_ = params; }
    /// The cameras are open, and get their time for a first pair.
    void opened(devices::TimePoint now);
    /// A pair of frames came. Whether it may be shown: not where it was captured too long ago, as
    /// what a camera held back is.
    [[nodiscard]] bool arrived(devices::TimePoint now, devices::TimePoint capturedAt);
    /// Of the pair that came last, when it came.
    [[nodiscard]] devices::Duration age() const { return age_; }
    /// That pair is on the panel.
    void presented(devices::TimePoint now) { pair_ = now - age_; }
    /// A colour frame is on the panel without depth.
    void colored(devices::TimePoint now) { color_ = now; }

    /// `sensors`: none while the input is not open.
    [[nodiscard]] Shown decide(devices::TimePoint now,
                               const std::optional<devices::SensorStatuses>& sensors) const;
    /// Whether colour frames are to be taken without waiting for depth.
    [[nodiscard]] bool wantsColor(devices::TimePoint now,
                                  const std::optional<devices::SensorStatuses>& sensors) const;
    /// What Idle says.
    [[nodiscard]] const std::string&
    message(devices::TimePoint now, const std::optional<devices::SensorStatuses>& sensors) const;

  private:
    [[nodiscard]] devices::Duration patience() const;
    [[nodiscard]] bool silent(const devices::SensorStatus& sensor, devices::TimePoint now) const;

    config::IdleParams params_;
    devices::TimePoint start_;
    std::optional<devices::TimePoint> arrived_;      ///< the last pair
    devices::Duration age_{0};                       ///< of that one when it came
    devices::Duration spacing_{0}, earlier_{0};      ///< of the last pairs
    std::optional<devices::TimePoint> pair_, color_; ///< when shown, less its age; when shown
};

} // namespace autostereo::daemon

#pragma once

#include "calib/eye_pair.hpp"
#include "devices/tracking/eye_source.hpp"
#include "devices/tracking/one_euro.hpp"
#include "devices/tracking/params.hpp"

#include <cstdint>
#include <optional>

namespace autostereo::devices {

/// From samples that are noisy, late and sometimes missing to where the eyes are when what is drawn
/// now is seen. Each eye is smoothed (OneEuro) and carried on at constant velocity over its age and
/// params.delay. Without samples for params.lostAfter the eyes ease to the nominal ones within
/// params.ease, and back as soon as there are samples again; no jump ever. What they are at a
/// moment depends on the samples and that moment only. Thread-bound.
class EyeFollower {
  public:
    EyeFollower(const ViewerParams& params, const calib::EyePair& nominal)
        : params_(params), nominal_(nominal) {}

    void add(const EyeSample& sample);
    [[nodiscard]] calib::EyePair eyes(TimePoint now) const;
    /// Whether there was a sample lately.
    [[nodiscard]] bool isTracked(TimePoint now) const;
    [[nodiscard]] std::optional<TimePoint> lastSample() const { return last_; }
    /// Samples that were not later than the one before.
    [[nodiscard]] std::uint64_t disordered() const { return disordered_; }

  private:
    [[nodiscard]] double share(TimePoint now) const;
    [[nodiscard]] calib::EyePair followed(TimePoint when) const;

    ViewerParams params_;
    calib::EyePair nominal_;
    std::optional<OneEuro> left_, right_;
    std::optional<TimePoint> last_;
    TimePoint foundAt_{};   ///< of the samples without a gap up to the last one
    double shareFound_ = 0; ///< of the followed eyes in what was given then
    std::uint64_t disordered_ = 0;
};

} // namespace autostereo::devices

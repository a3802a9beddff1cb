#pragma once

#include "devices/clock.hpp"
#include "devices/tracking/params.hpp"

#include <glm/vec3.hpp>

namespace autostereo::devices {

/// A place that moves, smoothed by the one-euro filter (Casiez, Roussel, Vogel, CHI 2012): an
/// exponential low pass whose cutoff is cutoffHz + cutoffPerSpeed * speed, one cutoff for all three
/// coordinates; the speed is that of the raw samples through a low pass of its own. Value type.
class OneEuro {
  public:
    OneEuro(const OneEuroParams& params, TimePoint at, const glm::dvec3& place)
        : params_(params), at_(at), raw_(place), smooth_(place) {}

    /// A later sample; one that is not later changes nothing.
    void add(TimePoint at, const glm::dvec3& place);
    /// Where it is expected at a time, at constant velocity from the last sample on. What the low
    /// pass lags behind at that velocity is added: (1 - a) / a sample periods for weights a. So a
    /// steady motion is met exactly, but for the share restSpeed^2 / speed^2 that is not believed.
    [[nodiscard]] glm::dvec3 at(TimePoint when) const;

  private:
    OneEuroParams params_;
    TimePoint at_;
    glm::dvec3 raw_, smooth_, velocity_{0}; ///< m, m, m/s
    double lagS_ = 0;
};

} // namespace autostereo::devices

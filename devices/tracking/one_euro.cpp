#include "devices/tracking/one_euro.hpp"

#include <glm/geometric.hpp>

#include <numbers>

namespace autostereo::devices {

namespace {

double seconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

/// Weight of a new sample after `period` seconds.
double weight(double cutoffHz, double period) {
    const double timeConstant = 1 / (2 * std::numbers::pi * cutoffHz);
    return 1 / (1 + timeConstant / period);
}

} // namespace

void OneEuro::add(TimePoint at, const glm::dvec3& place) {
    const double period = seconds(at - at_);
    if (!(period > 0)) return;
    velocity_ += ((place - raw_) / period - velocity_) * weight(params_.velocityCutoffHz, period);
    const double cutoff = params_.cutoffHz + params_.cutoffPerSpeed * glm::length(velocity_);
    const double share = weight(cutoff, period);
    smooth_ += (place - smooth_) * share;
    lagS_ = (1 - share) / share * period;
    raw_ = place;
    at_ = at;
}

glm::dvec3 OneEuro::at(TimePoint when) const {
    const double square = glm::dot(velocity_, velocity_);
    if (square == 0) return smooth_;
    const double belief = square / (square + params_.restSpeed * params_.restSpeed);
    return smooth_ + velocity_ * (belief * (seconds(when - at_) + lagS_));
}

} // namespace autostereo::devices

#include "devices/tracking/eye_follower.hpp"

#include <algorithm>

namespace autostereo::devices {

namespace {

/// How far from 0 to 1 something has come that takes `whole`.
double part(Duration since, Duration whole) {
    if (whole <= Duration::zero()) return since > Duration::zero() ? 1 : 0;
    return static_cast<double>(since.count()) / static_cast<double>(whole.count());
}

double smoothStep(double share) { return share * share * (3 - 2 * share); }

} // namespace

void EyeFollower::add(const EyeSample& sample) {
    if (last_ && sample.at <= *last_) {
        ++disordered_;
        return;
    }
    if (!isTracked(sample.at)) {
        shareFound_ = share(sample.at);
        foundAt_ = sample.at;
        left_.emplace(params_.smoothing, sample.at, sample.eyes.left);
        right_.emplace(params_.smoothing, sample.at, sample.eyes.right);
    } else {
        left_->add(sample.at, sample.eyes.left);
        right_->add(sample.at, sample.eyes.right);
    }
    last_ = sample.at;
}

bool EyeFollower::isTracked(TimePoint now) const {
    return last_ && now - *last_ <= params_.lostAfter;
}

double EyeFollower::share(TimePoint now) const {
    if (!last_) return 0;
    const TimePoint lostAt = *last_ + params_.lostAfter;
    const double risen = shareFound_ + part(std::min(now, lostAt) - foundAt_, params_.ease);
    const double fallen = now > lostAt ? part(now - lostAt, params_.ease) : 0;
    return std::clamp(std::min(1.0, risen) - fallen, 0.0, 1.0);
}

calib::EyePair EyeFollower::followed(TimePoint when) const {
    return clamped({left_->at(when), right_->at(when)}); // a wild velocity leads nowhere
}

calib::EyePair EyeFollower::eyes(TimePoint now) const {
    if (!last_) return nominal_;
    // A lost viewer is not carried on for ever.
    const TimePoint known = std::min(now, *last_ + params_.lostAfter);
    return calib::mix(nominal_, followed(known + params_.delay), smoothStep(share(now)));
}

} // namespace autostereo::devices

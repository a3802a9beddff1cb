#include "devices/silence_watch.hpp"

#include <algorithm>
#include <chrono>

namespace autostereo::devices {

namespace {

constexpr Duration kLongest = std::chrono::seconds(2);
constexpr Duration kUnknownPeriod = std::chrono::milliseconds(200);
constexpr int kPeriods = 5;

} // namespace

void SilenceWatch::start(TimePoint now, Duration period) {
    period_ = period.count() > 0 ? period : kUnknownPeriod;
    deadline_ = now + kLongest;
}

void SilenceWatch::frame(TimePoint now, Duration exposure) {
    const Duration period = std::clamp(std::max(period_, exposure), Duration(0), kLongest);
    deadline_ = now + std::min(period * kPeriods * factor_, std::max(kLongest, 2 * period));
}

void SilenceWatch::expired() {
    constexpr int kMostPatient = 64;
    factor_ = std::min(2 * factor_, kMostPatient);
}

} // namespace autostereo::devices

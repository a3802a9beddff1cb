#include "devices/kinect2/usb/underrun_watch.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace autostereo::devices::kinect2 {

UnderrunWatch::UnderrunWatch(Duration span)
    : span_(static_cast<Duration::rep>(static_cast<double>(span.count()) * (1 - kFaster))) {}

bool UnderrunWatch::submitted(TimePoint before, TimePoint after) {
    const bool late = queueEnd_ && after + kLead > *queueEnd_;
    if (!queueEnd_) second_ = before;
    queueEnd_ = std::max(queueEnd_.value_or(before), before) + span_;
    ++submitted_;
    return late;
}

void UnderrunWatch::noneEnded(TimePoint time, int onTheirWay) {
    constexpr auto kLongEnough = std::chrono::seconds(1);
    if (onTheirWay <= 0 || !queueEnd_) return;
    const std::int64_t ended = submitted_ - onTheirWay;
    earliest_ = std::min(earliest_, time - (ended + 1) * span_);
    if (time < second_ + kLongEnough) return;
    second_ = time;
    queueEnd_ =
        std::max(*queueEnd_, std::exchange(earliest_, TimePoint::max()) + submitted_ * span_);
}

void UnderrunWatch::failed(TimePoint time) {
    if (queueEnd_) *queueEnd_ -= span_;
    earliest_ = TimePoint::max();
    second_ = time;
}

} // namespace autostereo::devices::kinect2

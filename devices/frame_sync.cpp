#include "devices/frame_sync.hpp"

#include <algorithm>
#include <utility>

namespace autostereo::devices {

namespace {

/// |a - b| for any two times: damaged files hold the extremes of the type.
Duration apart(TimePoint a, TimePoint b) {
    const auto later = static_cast<std::uint64_t>(std::max(a, b).time_since_epoch().count());
    const auto earlier = static_cast<std::uint64_t>(std::min(a, b).time_since_epoch().count());
    const auto longest = static_cast<std::uint64_t>(Duration::max().count());
    return Duration(static_cast<Duration::rep>(std::min(later - earlier, longest)));
}

} // namespace

void FrameSync::Stream::push(Frame frame, TimePoint arrivedAt, std::size_t limit) {
    const TimePoint time = frame.metadata().capturedAt;
    if (last == time) {
        ++unpaired;
        return;
    }
    const bool steppedBack = last && time < *last;
    const Duration before =
        std::exchange(step, last && !steppedBack ? apart(time, *last) : Duration{0});
    spacing = before > Duration{0} ? std::min(step, before) : step;
    last = time;
    if (steppedBack) discardOldest(waiting.size());
    if (waiting.size() == limit) discardOldest(1);
    waiting.push_back({std::move(frame), arrivedAt});
}

void FrameSync::Stream::discardOldest(std::size_t count) {
    waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(count));
    unpaired += count;
}

Frame FrameSync::Stream::takeOldest() {
    Frame frame = std::move(waiting.front().frame);
    waiting.erase(waiting.begin());
    ++paired;
    return frame;
}

StreamCounters FrameSync::Stream::counters() const {
    StreamCounters counters;
    counters.in = paired + unpaired;
    counters.paired = paired;
    counters.unpaired = unpaired;
    counters.pending = waiting.size();
    return counters;
}

Frame FrameSync::takeColor() {
    if (color_.waiting.empty()) return {};
    Frame newest = std::move(color_.waiting.back().frame);
    color_.discardOldest(color_.waiting.size());
    return newest;
}

void FrameSync::pushDepth(Frame frame, TimePoint arrivedAt) {
    flushed_ = false;
    depth_.push(std::move(frame), arrivedAt, kDepthKept);
}

void FrameSync::pushColor(Frame frame) {
    flushed_ = false;
    frame.metadata().capturedAt -= params_.colorLate;
    color_.push(std::move(frame), {}, kColorKept);
}

std::optional<RgbdFrame> FrameSync::decide(std::optional<TimePoint> now) {
    while (!depth_.waiting.empty()) {
        const Waiting& oldest = depth_.waiting.front();
        const TimePoint time = oldest.frame.metadata().capturedAt;
        const auto partner = nearestColor(time);
        if (!settled(time)) {
            const auto ripe = ripeAt();
            if (!ripe || !now || *now < *ripe) return std::nullopt;
        }
        if (!partner) {
            depth_.discardOldest(1);
            continue;
        }
        color_.discardOldest(*partner);
        return RgbdFrame{depth_.takeOldest(), color_.takeOldest(), pairs_++};
    }
    if (flushed_) color_.discardOldest(color_.waiting.size());
    return std::nullopt;
}

std::optional<std::size_t> FrameSync::nearestColor(TimePoint depthTime) const {
    std::optional<std::size_t> nearest;
    Duration least = params_.tolerance;
    for (std::size_t i = 0; i < color_.waiting.size(); ++i) {
        const Duration distance = apart(color_.waiting[i].frame.metadata().capturedAt, depthTime);
        if (distance > least || (nearest && distance == least)) continue;
        nearest = i;
        least = distance;
    }
    return nearest;
}

bool FrameSync::settled(TimePoint depthTime) const {
    const bool colorIsPast = color_.last && *color_.last >= depthTime;
    return colorIsPast || flushed_ || depth_.waiting.size() == kDepthKept;
}

Duration FrameSync::grace(TimePoint depthTime, TimePoint partner) const {
    // Colour frames come `spacing` apart, with jitter at the very least half of it; if even that
    // one would lie farther off than the partner, there is nothing to wait for.
    if (apart(depthTime, partner) < color_.spacing / 4) return Duration{0};
    return depth_.spacing.count() == 0 ? params_.tolerance
                                       : std::min(depth_.spacing / 2, params_.tolerance);
}

std::optional<TimePoint> FrameSync::ripeAt() const {
    if (depth_.waiting.empty()) return std::nullopt;
    const Waiting& oldest = depth_.waiting.front();
    const TimePoint time = oldest.frame.metadata().capturedAt;
    const auto partner = nearestColor(time);
    if (!partner) return std::nullopt;
    return oldest.arrivedAt + grace(time, color_.waiting[*partner].frame.metadata().capturedAt);
}

FeedCounters FrameSync::counters() const {
    FeedCounters counters;
    counters.depth = depth_.counters();
    counters.color = color_.counters();
    counters.pairs = pairs_;
    return counters;
}

} // namespace autostereo::devices

#include "devices/live_feed.hpp"

#include <algorithm>
#include <utility>

namespace autostereo::devices {

namespace {

void addSource(StreamCounters& stream, const SourceThread& thread) {
    const SourceThread::Counters source = thread.counters();
    stream.in += source.starved;
    stream.unpaired += source.starved;
    stream.damaged = source.damaged;
    stream.reconnects = source.reconnects;
}

} // namespace

LiveFeed::LiveFeed(Input input, Clock& clock, SyncParams sync, ReconnectParams reconnect)
    : clock_(clock), pairs_(sync),
      depth_("tof", std::move(input.depth), std::move(input.reopen.depth), pairs_.depth(), bell_,
             clock, reconnect),
      color_("color", std::move(input.color), std::move(input.reopen.color), pairs_.color(), bell_,
             clock, reconnect) {}

std::optional<RgbdFrame> LiveFeed::next(std::chrono::milliseconds wait) noexcept {
    const TimePoint deadline = clock_.now() + wait;
    while (!ended_) {
        const std::uint64_t rings = bell_.count();
        const bool last = depth_.ended() && color_.ended(); // before looking: they push no more
        std::optional<RgbdFrame> pair = pairs_.take(clock_.now(), last);
        ended_ = last;
        const TimePoint now = clock_.now();
        if (pair || now >= deadline) return pair;
        bell_.wait(rings, std::min(deadline, pairs_.ripeAt().value_or(deadline)) - now);
    }
    return std::nullopt;
}

SensorStatuses LiveFeed::sensors() const { return {depth_.status(), color_.status()}; }

FeedCounters LiveFeed::counters() const noexcept {
    FeedCounters counters = pairs_.counters();
    addSource(counters.depth, depth_);
    addSource(counters.color, color_);
    return counters;
}

} // namespace autostereo::devices

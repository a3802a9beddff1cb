#include "devices/live_feed.hpp"

#include <algorithm>
#include <utility>

namespace autostereo::devices {

namespace {

/// Turns of emptying both queues in one call, so that a writer faster than us cannot hold us.
constexpr int kMostTurns = 16;

void addUpstream(StreamCounters& stream, const FrameQueue<Frame>& queue,
                 const SourceThread& thread) {
    const SourceThread::Counters source = thread.counters();
    const std::uint64_t lost = queue.dropped() + source.starved;
    stream.in += lost;
    stream.unpaired += lost;
    stream.pending += queue.size();
    stream.damaged = source.damaged;
    stream.reconnects = source.reconnects;
}

} // namespace

LiveFeed::LiveFeed(Input input, Clock& clock, SyncParams sync, ReconnectParams reconnect)
    : clock_(clock), sync_(sync),
      depth_("tof", std::move(input.depth), std::move(input.reopen.depth), depthQueue_, bell_,
             clock, reconnect),
      color_("color", std::move(input.color), std::move(input.reopen.color), colorQueue_, bell_,
             clock, reconnect) {}

std::optional<RgbdFrame> LiveFeed::next(std::chrono::milliseconds wait) noexcept {
    const TimePoint deadline = clock_.now() + wait;
    while (!ended_) {
        const std::uint64_t rings = bell_.count();
        const bool last = depth_.ended() && color_.ended(); // before looking: they push no more
        std::optional<RgbdFrame> pair = newestPair(last);
        ended_ = last;
        const TimePoint now = clock_.now();
        if (pair || now >= deadline) return pair;
        bell_.wait(rings, std::min(deadline, sync_.ripeAt().value_or(deadline)) - now);
    }
    return std::nullopt;
}

std::optional<RgbdFrame> LiveFeed::newestPair(bool last) {
    std::optional<RgbdFrame> newest;
    for (int turn = 0; turn < kMostTurns; ++turn) {
        auto color = colorQueue_.take();
        auto depth = depthQueue_.take();
        if (!color && !depth) break;
        if (color) sync_.pushColor(std::move(*color));
        if (depth) sync_.pushDepth(std::move(*depth), clock_.now());
        settle(newest);
    }
    if (last) sync_.flush();
    settle(newest);
    return newest;
}

void LiveFeed::settle(std::optional<RgbdFrame>& newest) {
    while (auto pair = sync_.next(clock_.now())) {
        if (newest) ++dropped_;
        newest = std::move(pair);
    }
}

SensorStatuses LiveFeed::sensors() const { return {depth_.status(), color_.status()}; }

FeedCounters LiveFeed::counters() const noexcept {
    FeedCounters counters = sync_.counters();
    counters.dropped = dropped_;
    addUpstream(counters.depth, depthQueue_, depth_);
    addUpstream(counters.color, colorQueue_, color_);
    return counters;
}

} // namespace autostereo::devices

#include "devices/newest_pair.hpp"

#include <utility>

namespace autostereo::devices {

namespace {

/// Turns of emptying both queues in one call, so that a writer faster than us cannot hold us.
constexpr int kMostTurns = 16;

void addUpstream(StreamCounters& stream, const NewestPair::Queue& queue) {
    const std::uint64_t lost = queue.dropped();
    stream.in += lost;
    stream.unpaired += lost;
    stream.pending += queue.size();
}

} // namespace

std::optional<RgbdFrame> NewestPair::take(TimePoint now, bool last) {
    std::optional<RgbdFrame> newest;
    for (int turn = 0; turn < kMostTurns; ++turn) {
        auto color = color_.take();
        auto depth = depth_.take();
        if (!color && !depth) break;
        if (color) sync_.pushColor(std::move(*color));
        if (depth) {
            const TimePoint arrivedAt = depth->metadata().arrivedAt;
            sync_.pushDepth(std::move(*depth), arrivedAt);
        }
        settle(newest);
    }
    if (last) sync_.flush();
    settle(newest, now);
    return newest;
}

void NewestPair::settle(std::optional<RgbdFrame>& newest, std::optional<TimePoint> now) {
    while (auto pair = now ? sync_.next(*now) : sync_.next()) {
        if (newest) ++dropped_;
        newest = std::move(pair);
    }
}

FeedCounters NewestPair::counters() const {
    FeedCounters counters = sync_.counters();
    counters.dropped = dropped_;
    addUpstream(counters.depth, depth_);
    addUpstream(counters.color, color_);
    return counters;
}

} // namespace autostereo::devices

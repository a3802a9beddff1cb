#include "devices/replay_feed.hpp"

#include <spdlog/spdlog.h>

#include <utility>

namespace autostereo::devices {

namespace {

/// Frames merged in one call at most, so that a recording without pairs cannot hold its consumer.
constexpr int kMostSteps = 64;

} // namespace

ReplayFeed::ReplayFeed(Input input, SyncParams sync, bool loop)
    : sync_(sync), epoch_(TimePoint(input.startsAt), input.nominalPeriod, 2), loop_(loop) {
    depth_.source = std::move(input.depth);
    color_.source = std::move(input.color);
    epoch_.start(TimePoint(input.startsAt));
}

std::optional<RgbdFrame> ReplayFeed::next(std::chrono::milliseconds) noexcept {
    for (int step = 0; step < kMostSteps && !ended_; ++step) {
        if (auto pair = sync_.next()) return pair;
        if (!fill(depth_) || !fill(color_)) return std::nullopt;
        if (!depth_.head.empty() || !color_.head.empty()) {
            merge();
        } else if (!loop_ || !startAgain()) {
            sync_.flush();
            if (auto pair = sync_.next()) return pair;
            ended_ = true;
        }
    }
    return std::nullopt;
}

/// False: nothing can be said about the stream yet.
bool ReplayFeed::fill(Stream& stream) {
    if (stream.ended || !stream.head.empty()) return true;
    ReadResult result = stream.source->read(TimePoint::max());
    if (std::holds_alternative<Timeout>(result)) return false;
    if (auto* frame = std::get_if<Frame>(&result)) {
        FrameMetadata& metadata = frame->metadata();
        metadata.capturedAt = stream.last = epoch_.timeOf(metadata.capturedAt);
        metadata.sequence += stream.firstSequence;
        stream.nextSequence = metadata.sequence + 1;
        stream.head = std::move(*frame);
        return true;
    }
    if (const auto* broken = std::get_if<Disconnected>(&result))
        spdlog::warn("replay: the recording breaks off: {}", broken->reason);
    stream.ended = true;
    return true;
}

/// The earlier head goes on; colour first where they are equal, so that the depth frame finds it.
void ReplayFeed::merge() {
    const bool depthFirst = color_.head.empty() ||
                            (!depth_.head.empty() &&
                             depth_.head.metadata().capturedAt < color_.head.metadata().capturedAt);
    if (depthFirst)
        sync_.pushDepth(std::exchange(depth_.head, Frame{}));
    else
        sync_.pushColor(std::exchange(color_.head, Frame{}));
}

bool ReplayFeed::startAgain() {
    for (Stream* stream : {&depth_, &color_}) {
        const bool empty = stream->nextSequence == stream->firstSequence;
        if (empty || !stream->source->rewind()) return false;
        epoch_.finish(stream->last);
        stream->firstSequence = stream->nextSequence;
        stream->ended = false;
    }
    return true;
}

SensorStatuses ReplayFeed::sensors() const {
    const auto stateOf = [](const Stream& stream) {
        return SensorStatus{stream.ended ? SensorState::Ended : SensorState::Streaming, {}, {}};
    };
    return {stateOf(depth_), stateOf(color_)};
}

FeedCounters ReplayFeed::counters() const noexcept {
    FeedCounters counters = sync_.counters();
    addUpstream(counters.depth, depth_);
    addUpstream(counters.color, color_);
    return counters;
}

void ReplayFeed::addUpstream(StreamCounters& counters, const Stream& stream) {
    const SourceCounters source = stream.source->counters();
    counters.in += source.starved;
    counters.unpaired += source.starved;
    counters.pending += stream.head.empty() ? 0 : 1;
    counters.damaged = source.damaged;
}

} // namespace autostereo::devices

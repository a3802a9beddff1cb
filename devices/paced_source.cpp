#include "devices/paced_source.hpp"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace autostereo::devices {

namespace {

/// How often a stream that has ended looks whether the others have too.
constexpr Duration kPoll = std::chrono::milliseconds(2);
/// A damaged time stamp stops a stream for no longer than this.
constexpr Duration kLongestWait = std::chrono::seconds(10);

} // namespace

PacedSource::PacedSource(std::unique_ptr<Source> source, std::shared_ptr<PlaybackEpoch> epoch,
                         Clock& clock, bool loop)
    : source_(std::move(source)), epoch_(std::move(epoch)), clock_(clock), loop_(loop) {}

ReadResult PacedSource::read(TimePoint deadline) noexcept {
    if (finished_) return nextRound(deadline);
    if (!held_.empty()) return release(deadline);
    ReadResult result = source_->read(deadline);
    if (auto* frame = std::get_if<Frame>(&result)) {
        stamp(*frame);
        held_ = std::move(*frame);
        releaseAt_ = std::min(held_.metadata().capturedAt, clock_.now() + kLongestWait);
        return release(deadline);
    }
    if (!std::holds_alternative<Ended>(result) || !loop_) return result;
    finished_ = true;
    epoch_->finish(clock_.now());
    return nextRound(deadline);
}

void PacedSource::stamp(Frame& frame) {
    epoch_->start(clock_.now());
    FrameMetadata& metadata = frame.metadata();
    metadata.capturedAt = epoch_->timeOf(metadata.capturedAt);
    metadata.sequence += firstSequence_;
    nextSequence_ = metadata.sequence + 1;
}

ReadResult PacedSource::release(TimePoint deadline) {
    if (releaseAt_ > clock_.now()) {
        clock_.sleepUntil(std::min(releaseAt_, deadline));
        if (releaseAt_ > clock_.now()) return Timeout{};
    }
    return std::exchange(held_, Frame{});
}

ReadResult PacedSource::nextRound(TimePoint deadline) {
    clock_.sleepUntil(std::min(deadline, clock_.now() + kPoll));
    if (epoch_->round() == round_) return Timeout{};
    if (!source_->rewind()) return Ended{};
    ++round_;
    firstSequence_ = nextSequence_;
    finished_ = false;
    return Timeout{};
}

Input paced(Input input, Clock& clock, bool loop) {
    std::vector<std::unique_ptr<Source>*> recorded;
    if (input.depth && !input.depthIsLive) recorded.push_back(&input.depth);
    if (input.color && !input.colorIsLive) recorded.push_back(&input.color);
    const int streams = static_cast<int>(recorded.size());
    const auto epoch =
        std::make_shared<PlaybackEpoch>(TimePoint(input.startsAt), input.nominalPeriod, streams);
    for (std::unique_ptr<Source>* stream : recorded)
        *stream = std::make_unique<PacedSource>(std::move(*stream), epoch, clock, loop);
    return input;
}

} // namespace autostereo::devices

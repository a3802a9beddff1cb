#include "devices/twin_stream.hpp"

#include <optional>
#include <utility>

namespace autostereo::devices {

namespace {

/// Frames one side may lie behind the other.
constexpr std::size_t kMostWaiting = 4;

} // namespace

TwinStream::TwinStream(std::unique_ptr<Source> real, Painter painter, bool comesBack)
    : source_(std::move(real)), comesBack_(comesBack), painter_(std::move(painter)) {}

ReadResult TwinStream::read(Side side, TimePoint deadline) {
    std::unique_lock lock(mutex_);
    Reader& reader = readers_[side];
    if (reader.round != round_) return Ended{};
    const auto isToBeTold = [&] { return side == Real && lost_; };
    const auto somethingToDo = [&] {
        return !reader.waiting.empty() || ended_ || isToBeTold() || (!reading_ && source_);
    };
    if (!changed_.wait_until(lock, deadline, somethingToDo)) return Timeout{};
    if (reader.waiting.empty()) {
        if (ended_) return Ended{};
        if (isToBeTold()) return Disconnected{*std::exchange(lost_, std::nullopt)};
        ReadResult other = readBoth(deadline, lock);
        if (reader.waiting.empty()) return other;
    }
    Frame frame = std::move(reader.waiting.front());
    reader.waiting.pop_front();
    ++reader.handedOut;
    return frame;
}

/// One frame for each side, or what the real source said instead.
ReadResult TwinStream::readBoth(TimePoint deadline, std::unique_lock<std::mutex>& lock) {
    reading_ = true;
    lock.unlock(); // the other side may fetch what waits for it
    ReadResult result = source_->read(deadline);
    const SourceCounters counters = source_->counters();
    auto* frame = std::get_if<Frame>(&result);
    std::optional<Frame> companion;
    if (frame != nullptr) companion = pool_.acquire(painter_.describe(frame->metadata()));
    if (companion) painter_.paint(*frame, *companion);
    lock.lock();
    reading_ = false;
    real_ = counters;
    ended_ = std::holds_alternative<Ended>(result);
    if (frame != nullptr) {
        keep(readers_[Companion], std::move(companion));
        keep(readers_[Real], std::move(*frame));
        result = Timeout{};
    }
    if (const auto* gone = std::get_if<Disconnected>(&result); gone != nullptr && comesBack_) {
        lost_ = gone->reason;
        source_.reset(); // a device can be open only once
        result = Timeout{};
    }
    changed_.notify_all();
    return result;
}

void TwinStream::replace(std::unique_ptr<Source> real) {
    const std::scoped_lock lock(mutex_);
    source_ = std::move(real);
    real_ = {};
    readers_[Real].handedOut = readers_[Real].lost = 0;
    changed_.notify_all();
}

void TwinStream::keep(Reader& reader, std::optional<Frame> frame) {
    if (!frame) {
        ++reader.lost;
        return;
    }
    if (reader.waiting.size() == kMostWaiting) {
        reader.waiting.pop_front();
        ++reader.lost;
    }
    reader.waiting.push_back(std::move(*frame));
}

bool TwinStream::rewind(Side side) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !reading_; });
    Reader& reader = readers_[side];
    if (reader.round == round_) {
        if (!source_ || !source_->rewind()) return false;
        for (Reader& each : readers_)
            each.waiting.clear();
        ++round_;
        ended_ = false;
    }
    reader.round = round_;
    return true;
}

SourceCounters TwinStream::counters(Side side) const {
    const std::scoped_lock lock(mutex_);
    const Reader& reader = readers_[side];
    if (side == Companion) return {reader.handedOut, 0, reader.lost};
    return {reader.handedOut, real_.damaged, real_.starved + reader.lost};
}

} // namespace autostereo::devices

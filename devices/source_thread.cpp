#include "devices/source_thread.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include <pthread.h>

namespace autostereo::devices {

namespace {

/// Longest time without a look at the stop token.
constexpr Duration kSlice = std::chrono::milliseconds(50);

} // namespace

SourceThread::SourceThread(std::string name, std::unique_ptr<Source> source, Reopen reopen,
                           FrameQueue<Frame>& queue, Doorbell& bell, Clock& clock,
                           ReconnectParams reconnect)
    : name_(std::move(name)), source_(std::move(source)), reopen_(std::move(reopen)), queue_(queue),
      bell_(bell), clock_(clock), params_(reconnect), delay_(reconnect.firstDelay),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

SourceThread::Counters SourceThread::counters() const noexcept {
    return {damaged_.load(std::memory_order_acquire), starved_.load(std::memory_order_acquire),
            reconnects_.load(std::memory_order_acquire)};
}

SensorStatus SourceThread::status() const {
    const std::scoped_lock lock(statusMutex_);
    return status_;
}

void SourceThread::note(SensorState state, const std::string& reason) {
    const std::scoped_lock lock(statusMutex_);
    status_.state = state;
    if (state == SensorState::Streaming) status_.lastFrame = clock_.now();
    if (!reason.empty()) status_.reason = reason;
}

void SourceThread::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), name_.c_str());
    bool goOn = true;
    while (goOn && !stop.stop_requested()) {
        ReadResult result = source_->read(clock_.now() + kSlice);
        publish();
        goOn = handle(result, stop);
    }
    note(SensorState::Ended);
    ended_.store(true, std::memory_order_release);
    bell_.ring();
}

bool SourceThread::handle(ReadResult& result, const std::stop_token& stop) {
    if (auto* frame = std::get_if<Frame>(&result)) {
        frame->metadata().arrivedAt = clock_.now();
        queue_.push(std::move(*frame));
        bell_.ring();
        note(SensorState::Streaming);
        delay_ = params_.firstDelay;
        return true;
    }
    if (const auto* lost = std::get_if<Disconnected>(&result)) return reconnect(stop, lost->reason);
    return !std::holds_alternative<Ended>(result);
}

bool SourceThread::reconnect(const std::stop_token& stop, const std::string& reason) {
    note(SensorState::Lost, reason);
    if (!reopen_) {
        spdlog::warn("{}: source lost and cannot be reopened: {}", name_, reason);
        return false;
    }
    spdlog::warn("{}: sensor lost, trying to reopen it: {}", name_, reason);
    const SourceCounters last = source_->counters();
    closed_.damaged += last.damaged;
    closed_.starved += last.starved;
    source_.reset(); // a device can be open only once
    while (!source_) {
        waitFor(delay_, stop);
        if (stop.stop_requested()) return false;
        delay_ = std::min(delay_ * 2, params_.longestDelay);
        try {
            source_ = reopen_();
        } catch (const std::exception& error) {
            spdlog::debug("{}: still away: {}", name_, error.what());
        }
    }
    note(SensorState::Starting);
    reconnects_.fetch_add(1, std::memory_order_release);
    spdlog::info("{}: sensor is back", name_);
    return true;
}

void SourceThread::waitFor(Duration duration, const std::stop_token& stop) {
    const TimePoint end = clock_.now() + duration;
    for (TimePoint now = clock_.now(); now < end && !stop.stop_requested(); now = clock_.now())
        clock_.sleepUntil(std::min(end, now + kSlice));
}

void SourceThread::publish() {
    const SourceCounters open = source_->counters();
    damaged_.store(closed_.damaged + open.damaged, std::memory_order_release);
    starved_.store(closed_.starved + open.starved, std::memory_order_release);
}

} // namespace autostereo::devices

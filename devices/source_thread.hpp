#pragma once

#include "devices/doorbell.hpp"
#include "devices/feed.hpp"
#include "devices/frame_queue.hpp"
#include "devices/params.hpp"
#include "devices/source.hpp"

#include <atomic>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

namespace autostereo::devices {

/// The only thread a sensor has: reads its source into the queue and rings the bell. When the
/// sensor goes away it closes the source and reopens it, waiting between attempts, each time twice
/// as long. Destruction stops it within one read slice (50 ms). Queue, bell and clock must outlive
/// it. The counters may be read on any thread.
class SourceThread {
  public:
    /// Opens the sensor again; throws while it is not there. Empty: a lost sensor is an end.
    using Reopen = devices::Reopen;

    struct Counters {
        std::uint64_t damaged = 0;
        std::uint64_t starved = 0;
        std::uint64_t reconnects = 0;
    };

    /// `name` is the thread's, at most 15 characters.
    SourceThread(std::string name, std::unique_ptr<Source> source, Reopen reopen,
                 FrameQueue<Frame>& queue, Doorbell& bell, Clock& clock, ReconnectParams reconnect);

    /// No frame will be pushed any more.
    [[nodiscard]] bool ended() const noexcept { return ended_.load(std::memory_order_acquire); }
    [[nodiscard]] Counters counters() const noexcept;
    /// On any thread.
    [[nodiscard]] SensorStatus status() const;

  private:
    void run(const std::stop_token& stop);
    [[nodiscard]] bool handle(ReadResult& result, const std::stop_token& stop);
    [[nodiscard]] bool reconnect(const std::stop_token& stop, const std::string& reason);
    void waitFor(Duration duration, const std::stop_token& stop);
    void publish();
    void note(SensorState state, const std::string& reason = {});

    std::string name_;
    std::unique_ptr<Source> source_;
    Reopen reopen_;
    FrameQueue<Frame>& queue_;
    Doorbell& bell_;
    Clock& clock_;
    ReconnectParams params_;
    Duration delay_;
    SourceCounters closed_; ///< of sources that went away
    std::atomic<std::uint64_t> damaged_{0};
    std::atomic<std::uint64_t> starved_{0};
    std::atomic<std::uint64_t> reconnects_{0};
    std::atomic<bool> ended_{false};
    mutable std::mutex statusMutex_;
    SensorStatus status_;
    std::jthread thread_; // last: it uses all of the above
};

} // namespace autostereo::devices

#pragma once

#include "devices/frame_pool.hpp"
#include "devices/source.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace autostereo::test {

/// A tiny frame whose bytes all hold its sequence number (mod 251).
inline devices::Frame tinyFrame(devices::FramePool& pool, devices::PixelFormat format,
                                devices::TimePoint capturedAt, std::uint64_t sequence = 0) {
    devices::FrameMetadata metadata;
    metadata.format = format;
    metadata.width = 4;
    metadata.height = 3;
    metadata.sequence = sequence;
    metadata.capturedAt = capturedAt;
    auto frame = pool.acquire(metadata);
    if (!frame) return {};
    std::ranges::fill(frame->pixels(), static_cast<std::byte>(sequence % 251));
    return std::move(*frame);
}

inline bool isWhole(const devices::Frame& frame) {
    const auto expected = static_cast<std::byte>(frame.metadata().sequence % 251);
    return !frame.empty() &&
           std::ranges::all_of(frame.pixels(), [&](std::byte pixel) { return pixel == expected; });
}

enum class Then { Ends, Disconnects };

/// A recording of tiny frames taken at the given times. Never waits.
class FakeSource final : public devices::Source {
  public:
    FakeSource(devices::PixelFormat format, std::vector<devices::Duration> times,
               Then then = Then::Ends)
        : format_(format), times_(std::move(times)), then_(then) {}

    [[nodiscard]] devices::ReadResult read(devices::TimePoint) noexcept override {
        if (next_ == times_.size()) {
            if (then_ == Then::Disconnects) return devices::Disconnected{"cable pulled"};
            return devices::Ended{};
        }
        const devices::TimePoint time(times_[next_]);
        devices::Frame frame = tinyFrame(pool_, format_, time, next_);
        ++next_;
        if (frame.empty()) {
            ++counters_.starved;
            return devices::Timeout{};
        }
        ++counters_.delivered;
        return frame;
    }
    [[nodiscard]] bool rewind() noexcept override {
        next_ = 0;
        return true;
    }
    [[nodiscard]] devices::SourceCounters counters() const noexcept override { return counters_; }

  private:
    devices::FramePool pool_{devices::kFramesOnTheWay};
    devices::PixelFormat format_;
    std::vector<devices::Duration> times_;
    Then then_;
    std::size_t next_ = 0;
    devices::SourceCounters counters_;
};

/// `count` times, `period` apart, the first at `first`.
inline std::vector<devices::Duration> regularTimes(int count, devices::Duration period,
                                                   devices::Duration first = {}) {
    std::vector<devices::Duration> times;
    times.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        times.push_back(first + i * period);
    return times;
}

} // namespace autostereo::test

#pragma once

#include "devices/doorbell.hpp"
#include "devices/feed.hpp"
#include "devices/input.hpp"
#include "devices/newest_pair.hpp"
#include "devices/source_thread.hpp"

namespace autostereo::devices {

/// The live feed: one thread per source, a queue behind each, and the pairing on the consumer's
/// thread. Never lags: of several pairs that are ready `next` gives the newest and counts the
/// others as dropped. Takes both sources of a complete input; recordings are to be `paced`. Frames
/// that a queue dropped or for which a source had no room count as unpaired. Thread-bound.
class LiveFeed final : public Feed {
  public:
    LiveFeed(Input input, Clock& clock, SyncParams sync, ReconnectParams reconnect);

    [[nodiscard]] std::optional<RgbdFrame> next(std::chrono::milliseconds wait) noexcept override;
    [[nodiscard]] bool ended() const noexcept override { return ended_; }
    [[nodiscard]] FeedCounters counters() const noexcept override;
    [[nodiscard]] SensorStatuses sensors() const override;
    [[nodiscard]] Frame takeColor() noexcept override { return pairs_.takeColor(); }

  private:
    Clock& clock_;
    NewestPair pairs_;
    Doorbell bell_;
    bool ended_ = false;
    // Last, so that the threads end before what they use.
    SourceThread depth_;
    SourceThread color_;
};

} // namespace autostereo::devices

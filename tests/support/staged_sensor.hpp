#pragma once

#include "devices/frame_pool.hpp"
#include "devices/input.hpp"

#include <cstdint>
#include <memory>
#include <mutex>
#include <random>
#include <vector>

namespace autostereo::test {

/// What is the matter with a sensor.
enum class SensorFault : std::uint8_t {
    None,
    Unplugged,
    SlowToCome, ///< gone, and opening it takes as long as the fault
    Silent,
    Burst, ///< silent, then everything at once
    Late,  ///< frames come `amount` after they were captured
    OtherSize,
    OtherFormat, ///< grey colour, depth in tenths of a millimetre
    Zero,        ///< every sample
    Saturated,
    Garbage,
    Damaged,  ///< unreadable frames
    Back,     ///< stamps are `amount` too early,
    Forward,  ///< too late,
    Extreme,  ///< the least and the greatest of the type in turn,
    Stuck,    ///< all the same,
    Jitter,   ///< up to `amount` off,
    Drift,    ///< a tenth too slow
    Numbered, ///< frame numbers jump by 2^32 and 2^53
    Repeated, ///< all frames have one number
    Twice,    ///< each comes twice
    Flood     ///< twenty times as many
};

/// What the test's thread tells a sensor. Thread-safe.
class SensorOrders {
  public:
    struct Order {
        SensorFault fault = SensorFault::None;
        devices::Duration amount{0};
        std::uint64_t number = 0; ///< counts orders
    };
    void give(SensorFault fault, devices::Duration amount = {}) {
        const std::scoped_lock lock(mutex_);
        order_ = {fault, amount, order_.number + 1};
    }
    [[nodiscard]] Order now() const {
        const std::scoped_lock lock(mutex_);
        return order_;
    }

  private:
    mutable std::mutex mutex_;
    Order order_;
};

/// Frames of a recording or simulation, in memory.
struct Reel {
    struct Picture {
        devices::FrameMetadata form;
        std::vector<std::byte> pixels, amplitude;
    };
    std::vector<Picture> pictures;
};
[[nodiscard]] std::shared_ptr<const Reel> readReel(devices::Source& source, std::size_t pictures);

/// A live sensor that plays a reel for ever, once a `period` on the host's clock: the exposure's
/// number says which picture it gives. What is ordered goes wrong. Thread-bound.
class StagedSensor final : public devices::Source {
  public:
    /// Throws DeviceError while it is unplugged.
    StagedSensor(std::shared_ptr<const Reel> reel, const SensorOrders& orders,
                 devices::Duration period, devices::Duration offset);

    /// Of the exposure whose middle is nearest.
    [[nodiscard]] static std::uint64_t exposureAt(devices::TimePoint time,
                                                  devices::Duration period);

    [[nodiscard]] devices::ReadResult read(devices::TimePoint deadline) noexcept override;
    [[nodiscard]] bool rewind() noexcept override { return false; }
    [[nodiscard]] devices::SourceCounters counters() const noexcept override { return counters_; }

  private:
    using Order = SensorOrders::Order;
    [[nodiscard]] devices::Frame expose(const Order& order);
    void spoil(devices::Frame& frame, const Order& order);
    [[nodiscard]] devices::TimePoint stamp(const Order& order);
    void advance(const Order& order);

    std::shared_ptr<const Reel> reel_;
    const SensorOrders& orders_;
    devices::Duration period_, offset_;
    devices::SteadyClock clock_;
    devices::FramePool pool_{devices::kFramesOnTheWay};
    devices::SourceCounters counters_;
    std::minstd_rand random_{1};
    SensorFault openedWith_;         ///< size and format change with an opening only
    devices::TimePoint next_;        ///< middle of the next exposure
    std::uint64_t seen_ = 0;         ///< the order's number,
    devices::TimePoint orderedAt_{}; ///< and when it was first seen
    std::uint64_t numbered_ = 0;
    bool holdsBack_ = false;
    int copies_ = 0; ///< of this exposure so far
};

/// The input with staged sensors in place of its own, which show so many of its pictures, one a
/// `period`. The orders must outlive it.
[[nodiscard]] devices::Input staged(devices::Input input, const SensorOrders& depth,
                                    const SensorOrders& color, std::size_t pictures,
                                    devices::Duration period);

} // namespace autostereo::test

#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

namespace autostereo::devices {

/// Bounded mailbox between one writing and one reading thread; newest wins. `push` never blocks and
/// never fails: when the queue is full it destroys the oldest element and counts it. `take` gives
/// the oldest element that is left, in the order of pushing. Lock-free; the elements lie in
/// Capacity + 2 preallocated nodes, of which writer and reader own one each.
/// pushed = taken + dropped + size once both threads rest.
template<typename T, std::size_t Capacity = 4>
class FrameQueue {
    static_assert(Capacity >= 1 && Capacity <= 250);
    static_assert(std::is_nothrow_move_constructible_v<T>);

  public:
    FrameQueue() {
        for (std::size_t i = 0; i < Capacity; ++i)
            slots_[i].store(pack({0, i, false}), std::memory_order_relaxed);
    }
    FrameQueue(const FrameQueue&) = delete;
    FrameQueue& operator=(const FrameQueue&) = delete;

    /// Writer only.
    void push(T value) noexcept {
        nodes_[writerNode_].emplace(std::move(value));
        const std::uint64_t sequence = pushed_.load(std::memory_order_relaxed);
        const Slot old = unpack(slots_[sequence % Capacity].exchange(
            pack({sequence, writerNode_, true}), std::memory_order_acq_rel));
        writerNode_ = old.node;
        if (old.full) {
            nodes_[old.node].reset();
            count(dropped_);
        }
        count(pushed_);
    }

    /// Reader only. Nothing: the queue is empty.
    [[nodiscard]] std::optional<T> take() noexcept {
        for (;;) { // another turn only after the writer has moved on by Capacity elements
            std::atomic<std::uint64_t>& place = slots_[next_ % Capacity];
            std::uint64_t seen = place.load(std::memory_order_acquire);
            const Slot slot = unpack(seen);
            if (!slot.full) return std::nullopt;
            if (slot.sequence != next_) {
                // Overrun: the oldest element that can still be there.
                next_ = slot.sequence - (Capacity - 1);
                continue;
            }
            if (!place.compare_exchange_strong(seen, pack({next_, readerNode_, false}),
                                               std::memory_order_acq_rel,
                                               std::memory_order_relaxed))
                continue;
            readerNode_ = slot.node;
            std::optional<T> value = std::exchange(nodes_[slot.node], std::nullopt);
            ++next_;
            count(taken_);
            return value;
        }
    }

    // The counters may be read on any thread.
    [[nodiscard]] std::uint64_t pushed() const noexcept { return read(pushed_); }
    [[nodiscard]] std::uint64_t taken() const noexcept { return read(taken_); }
    [[nodiscard]] std::uint64_t dropped() const noexcept { return read(dropped_); }
    /// Elements waiting, counted one by one; between two pushes it may be out of date.
    [[nodiscard]] std::size_t size() const noexcept {
        std::size_t waiting = 0;
        for (const auto& slot : slots_)
            if (unpack(slot.load(std::memory_order_acquire)).full) ++waiting;
        return waiting;
    }

  private:
    /// What an atomic slot says: which element, in which node, and whether it is still there.
    struct Slot {
        std::uint64_t sequence;
        std::size_t node;
        bool full;
    };
    // 55 bits of sequence last a thousand years at a million elements a second.
    static std::uint64_t pack(const Slot& slot) noexcept {
        return slot.sequence << 9 | static_cast<std::uint64_t>(slot.node) << 1 |
               static_cast<std::uint64_t>(slot.full);
    }
    static Slot unpack(std::uint64_t bits) noexcept {
        return {bits >> 9, static_cast<std::size_t>(bits >> 1 & 0xff), (bits & 1) != 0};
    }

    using Counter = std::atomic<std::uint64_t>;
    /// Each counter has one writing thread.
    static void count(Counter& counter) noexcept {
        counter.store(counter.load(std::memory_order_relaxed) + 1, std::memory_order_release);
    }
    static std::uint64_t read(const Counter& counter) noexcept {
        return counter.load(std::memory_order_acquire);
    }

    // The two threads' own data lie on cache lines of their own.
    static constexpr std::size_t kLine = 64;
    alignas(kLine) std::array<std::atomic<std::uint64_t>, Capacity> slots_;
    std::array<std::optional<T>, Capacity + 2> nodes_;
    alignas(kLine) std::size_t writerNode_ = Capacity;
    Counter pushed_{0};
    Counter dropped_{0};
    alignas(kLine) std::size_t readerNode_ = Capacity + 1;
    std::uint64_t next_ = 0; ///< sequence of the element to take
    Counter taken_{0};
};

} // namespace autostereo::devices

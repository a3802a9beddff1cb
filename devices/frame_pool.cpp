#include "devices/frame_pool.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace autostereo::devices {

namespace {

std::size_t bytesNeeded(const FrameMetadata& metadata) {
    if (metadata.width <= 0 || metadata.height <= 0) return 0;
    const auto pixels =
        static_cast<std::size_t>(metadata.width) * static_cast<std::size_t>(metadata.height);
    const std::size_t amplitude = metadata.hasAmplitude ? sizeof(std::uint16_t) : 0;
    return frameBytes(metadata.format, metadata.width, metadata.height) + pixels * amplitude +
           metadata.encodedBytes;
}

} // namespace

class FramePool::Slots final : public Frame::Owner {
  public:
    explicit Slots(std::size_t count) : slots_(count) {}

    std::optional<Frame> acquire(const FrameMetadata& metadata) {
        for (std::size_t i = 0; i < slots_.size(); ++i) {
            Slot& slot = slots_[i];
            // Only this thread takes slots, so a free one stays free; acquire orders the reuse of
            // the storage after the last reader's accesses.
            if (slot.busy.load(std::memory_order_acquire)) continue;
            slot.fit(bytesNeeded(metadata));
            slot.busy.store(true, std::memory_order_relaxed);
            users_.fetch_add(1, std::memory_order_relaxed);
            return Frame(*this, i, slot.bytes(), metadata);
        }
        return std::nullopt;
    }

    void release(std::size_t slot) noexcept override {
        slots_[slot].busy.store(false, std::memory_order_release);
        leave();
    }

    /// The pool or a frame is gone; the last one deletes.
    void leave() noexcept {
        if (users_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
    }

    [[nodiscard]] std::size_t leased() const noexcept {
        return static_cast<std::size_t>(std::ranges::count_if(
            slots_, [](const Slot& slot) { return slot.busy.load(std::memory_order_relaxed); }));
    }

  private:
    struct Slot {
        std::atomic<bool> busy{false};
        std::unique_ptr<std::max_align_t[]> storage;
        std::size_t units = 0;

        /// With an eighth more than is needed, untouched until it is: JPEGs that ride along differ
        /// in size, and each longer one would cost fresh memory for the whole frame.
        void fit(std::size_t bytes) {
            const std::size_t needed =
                (bytes + sizeof(std::max_align_t) - 1) / sizeof(std::max_align_t);
            if (units >= needed) return;
            storage.reset(); // nothing to carry over to the bigger block
            units = 0;
            const std::size_t roomy = needed + needed / 8;
            storage = std::make_unique_for_overwrite<std::max_align_t[]>(roomy);
            units = roomy;
        }
        [[nodiscard]] std::span<std::byte> bytes() const {
            return std::as_writable_bytes(std::span(storage.get(), units));
        }
    };

    ~Slots() = default;

    std::vector<Slot> slots_;
    std::atomic<std::size_t> users_{1}; // the pool and every leased frame
};

FramePool::FramePool(std::size_t slots) : slots_(new Slots(slots)) {}

FramePool::~FramePool() { slots_->leave(); }

std::optional<Frame> FramePool::acquire(const FrameMetadata& metadata) {
    return slots_->acquire(metadata);
}

std::size_t FramePool::leased() const noexcept { return slots_->leased(); }

} // namespace autostereo::devices

#include "devices/frame_pool.hpp"

#include <algorithm>
#include <cassert>

namespace autostereo::devices {

namespace {

std::size_t bytesNeeded(const FrameMetadata& metadata) {
    if (metadata.width <= 0 || metadata.height <= 0) return 0;
    const auto pixels =
        static_cast<std::size_t>(metadata.width) * static_cast<std::size_t>(metadata.height);
    const std::size_t amplitude = metadata.hasAmplitude ? sizeof(std::uint16_t) : 0;
    return pixels * (bytesPerPixel(metadata.format) + amplitude);
}

} // namespace

FramePool::FramePool(std::size_t slots) : slots_(slots) {}

FramePool::~FramePool() { assert(leased() == 0 && "a frame outlived its pool"); }

std::optional<Frame> FramePool::acquire(const FrameMetadata& metadata) {
    for (std::size_t i = 0; i < slots_.size(); ++i) {
        Slot& slot = slots_[i];
        // Only this thread takes slots, so a free one stays free; acquire orders the reuse of the
        // storage after the last reader's accesses.
        if (slot.busy.load(std::memory_order_acquire)) continue;
        const std::size_t unit = sizeof(std::max_align_t);
        const std::size_t units = (bytesNeeded(metadata) + unit - 1) / unit;
        if (slot.storage.size() < units) {
            slot.storage.clear(); // nothing to carry over to the bigger block
            slot.storage.resize(units);
        }
        slot.busy.store(true, std::memory_order_relaxed);
        return Frame(*this, i, std::as_writable_bytes(std::span(slot.storage)), metadata);
    }
    return std::nullopt;
}

std::size_t FramePool::leased() const noexcept {
    return static_cast<std::size_t>(std::ranges::count_if(
        slots_, [](const Slot& slot) { return slot.busy.load(std::memory_order_relaxed); }));
}

void FramePool::release(std::size_t slot) noexcept {
    slots_[slot].busy.store(false, std::memory_order_release);
}

} // namespace autostereo::devices

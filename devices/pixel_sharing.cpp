#include "devices/pixel_sharing.hpp"

#include <spdlog/spdlog.h>

#include <utility>

namespace autostereo::devices {

const char* pixelWayName(PixelWay way) {
    switch (way) {
    case PixelWay::Filled:
        return "filled";
    case PixelWay::Exported:
        return "exported";
    case PixelWay::Copied:
        break;
    }
    return "copied";
}

void PixelSharing::offer(std::shared_ptr<PixelMemory> memory) {
    const std::scoped_lock lock(mutex_);
    if (answered_) return;
    memory_ = std::move(memory);
    way_ = memory_ ? PixelWay::Filled : PixelWay::Exported;
    answered_ = true;
    spdlog::info("color: pictures need no copy from now on ({})", pixelWayName(way_));
}

void PixelSharing::decline(const std::string& why) {
    const std::scoped_lock lock(mutex_);
    if (answered_) return;
    answered_ = true;
    spdlog::info("color: pictures are copied: {}", why);
}

void PixelSharing::refuse(PixelWay way, const std::string& why) {
    const std::scoped_lock lock(mutex_);
    if (way == PixelWay::Copied || way_ != way) return; // the other side was first
    const PixelWay next = way == PixelWay::Filled ? PixelWay::Exported : PixelWay::Copied;
    way_ = next;
    spdlog::info("color: pictures cannot be {}, {} instead: {}", pixelWayName(way),
                 pixelWayName(next), why);
}

std::shared_ptr<PixelMemory> PixelSharing::memory() const {
    const std::scoped_lock lock(mutex_);
    return memory_;
}

} // namespace autostereo::devices

#include "devices/kinect2/unit_packets.hpp"

namespace autostereo::devices::kinect2 {

bool UnitPackets::depth(std::span<const std::byte> packet, bool intact, TimePoint arrived,
                        TimedDepth& next) {
    if (!depthPackets_.append(packet, intact)) return false;
    depthPackets_.swapFrame(next.frame);
    next.capturedAt = clock_.depth(next.frame.timestamp, arrived);
    return true;
}

bool UnitPackets::color(std::span<const std::byte> packet, bool intact, TimePoint arrived,
                        TimedColor& next) {
    if (!intact) {
        colorPackets_.reset();
        return false;
    }
    const auto picture = colorPackets_.append(packet);
    if (!picture) return false;
    next.jpeg.assign(picture->jpeg.begin(), picture->jpeg.end());
    next.sequence = picture->sequence;
    next.capturedAt = clock_.color(picture->timestamp, picture->exposureMs, arrived);
    return true;
}

} // namespace autostereo::devices::kinect2

#include "devices/kinect2/depth_packets.hpp"

#include "devices/kinect2/little_endian.hpp"

#include <algorithm>

namespace autostereo::devices::kinect2 {

namespace {

constexpr unsigned kAllUsed = (1U << kUsedSubImages) - 1;

/// Behind each sub-image; 128 bytes of unknown use follow.
struct DepthFooter {
    std::uint32_t magic[2];
    std::uint32_t timestamp;
    std::uint32_t sequence;
    std::uint32_t subsequence;
    std::uint32_t length;
};

} // namespace

void DepthPackets::reset() {
    filled_ = 0;
    skipping_ = false;
    current_.reset();
    seen_ = 0;
}

bool DepthPackets::append(std::span<const std::byte> packet, bool intact) {
    if (!intact) ++counters_.badPackets;
    const bool fits = filled_ + packet.size() <= kTransferBytes;
    if (!intact || !fits || packet.empty()) {
        const bool cut = !intact || filled_ > 0;
        if (cut && !skipping_) ++counters_.brokenSubImages;
        filled_ = 0;
        // The rest of a damaged sub-image would only be taken for the beginning of the next.
        skipping_ = !intact || !fits;
        return false;
    }
    if (skipping_) return false;
    std::copy(packet.begin(), packet.end(), work_.begin() + static_cast<std::ptrdiff_t>(filled_));
    filled_ += packet.size();
    if (filled_ < kTransferBytes) return false;
    filled_ = 0;
    return finishSubImage();
}

bool DepthPackets::finishSubImage() {
    const auto footer = valueAt<DepthFooter>(work_, kSubImageBytes);
    if (footer.length != kSubImageBytes || footer.subsequence >= kSubImages) {
        ++counters_.brokenSubImages;
        return false;
    }
    if (current_ != footer.sequence) beginFrame(footer.sequence, footer.timestamp);
    if ((seen_ & kAllUsed) == kAllUsed || footer.subsequence >= kUsedSubImages) return false;
    std::copy_n(work_.begin(), kSubImageBytes,
                frame_.bytes.begin() +
                    static_cast<std::ptrdiff_t>(footer.subsequence * kSubImageBytes));
    seen_ |= 1U << footer.subsequence;
    if (seen_ != kAllUsed) return false;
    ++counters_.frames;
    return true;
}

void DepthPackets::beginFrame(std::uint32_t sequence, std::uint32_t timestamp) {
    if (current_ && seen_ != kAllUsed) ++counters_.brokenFrames;
    current_ = sequence;
    seen_ = 0;
    frame_.sequence = sequence;
    frame_.timestamp = timestamp;
}

} // namespace autostereo::devices::kinect2

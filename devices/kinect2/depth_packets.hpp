#pragma once

#include "devices/kinect2/sub_image.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace autostereo::devices::kinect2 {

/// Nine sub-images that belong together, as they came.
struct RawDepthFrame {
    std::vector<std::byte> bytes = std::vector<std::byte>(kUsedSubImages * kSubImageBytes);
    std::uint32_t timestamp = 0; ///< device clock of its first sub-image, units of 0.125 ms, wraps
    std::uint32_t sequence = 0;  ///< wraps

    [[nodiscard]] std::span<const std::byte, kSubImageBytes> subImage(std::size_t index) const {
        return std::span(bytes)
            .subspan(index * kSubImageBytes, kSubImageBytes)
            .first<kSubImageBytes>();
    }
};

/// Puts isochronous packets together: a sub-image and its footer are sent as packets of 33792
/// bytes, the last one short, and an empty one after it. What is lost, cut or doubled makes the
/// sub-image's length wrong, and its frame is dropped and counted; the wire carries no checksum, so
/// contents are not checked. Takes any bytes; memory is constant. Thread-bound.
class DepthPackets {
  public:
    static constexpr std::size_t kFooterBytes = 152;
    static constexpr std::size_t kTransferBytes = kSubImageBytes + kFooterBytes;

    struct Counters {
        std::uint64_t frames = 0;
        std::uint64_t brokenFrames = 0;    ///< seen in part: dropped
        std::uint64_t badPackets = 0;      ///< the bus said so
        std::uint64_t brokenSubImages = 0; ///< wrong length, or a footer that cannot be
    };

    /// One packet in order of arrival; `intact`: the bus reports no error. True: a frame is
    /// complete, to be fetched by `swapFrame` before the next packet.
    [[nodiscard]] bool append(std::span<const std::byte> packet, bool intact);
    /// Exchanges the complete frame for a used one; nothing is copied.
    void swapFrame(RawDepthFrame& frame) noexcept { std::swap(frame, frame_); }
    /// Forgets what is half read, as after the stream was started anew.
    void reset();
    [[nodiscard]] const Counters& counters() const { return counters_; }

  private:
    [[nodiscard]] bool finishSubImage();
    void beginFrame(std::uint32_t sequence, std::uint32_t timestamp);

    std::vector<std::byte> work_ = std::vector<std::byte>(kTransferBytes);
    std::size_t filled_ = 0;
    bool skipping_ = false; ///< until the next empty packet
    RawDepthFrame frame_;
    std::optional<std::uint32_t> current_; ///< sequence of the frame being put together
    unsigned seen_ = 0;                    ///< a bit for each sub-image of it
    Counters counters_;
};

} // namespace autostereo::devices::kinect2

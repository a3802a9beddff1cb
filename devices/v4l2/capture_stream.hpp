#pragma once

#include "devices/v4l2/capture_buffers.hpp"
#include "devices/v4l2/frame_clock.hpp"
#include "devices/v4l2/video_node.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>

namespace autostereo::devices::v4l2 {

/// What the driver agreed to; may differ from what was asked for.
struct Agreed {
    Mode mode;
    std::size_t stride = 0;       ///< bytes from row to row of the first plane
    std::size_t pictureBytes = 0; ///< at most
    YuvMeaning yuv;
};

/// One picture in a buffer of the driver's, valid until it is given back.
struct Captured {
    std::span<const std::byte> bytes;
    std::uint32_t sequence = 0;
    Duration stamp{0};
    StampOf stampOf = StampOf::FrameEnd;
    bool damaged = false; ///< the driver says so
    std::uint32_t buffer = 0;
};

/// A running capture stream: set up and started by construction, over mapped buffers of the
/// driver's, stopped by destruction. Movable, thread-bound.
class CaptureStream {
  public:
    /// Throws DeviceError: refused, busy (with who holds it), gone.
    CaptureStream(VideoNode node, const Mode& mode);
    CaptureStream(CaptureStream&&) noexcept = default;
    CaptureStream& operator=(CaptureStream&&) = delete;
    CaptureStream(const CaptureStream&) = delete;
    CaptureStream& operator=(const CaptureStream&) = delete;
    ~CaptureStream();

    struct Nothing {};
    /// The stream is broken; it has to be opened anew.
    struct Broken {
        std::string reason;
    };
    using Outcome = std::variant<Captured, Nothing, Broken>;

    /// Waits until `deadline` at most.
    [[nodiscard]] Outcome wait(TimePoint deadline);
    void giveBack(const Captured& captured);

    /// Goes on over other buffers. What was lent stays valid; whoever was given a `Captured` has
    /// given it back. Throws DeviceError, std::runtime_error and has to be given others then.
    void useBuffers(PixelWay way, PixelMemory* memory, const BufferShape& shape);
    /// In place of giving it back; none: too few would be left to the driver.
    [[nodiscard]] std::shared_ptr<const SharedPixels>
    lend(const Captured& captured, std::shared_ptr<PixelSharing> sharing) const;
    [[nodiscard]] PixelWay way() const { return way_; }

    [[nodiscard]] const Agreed& agreed() const { return agreed_; }
    [[nodiscard]] const VideoNode& node() const { return node_; }

  private:
    void agreeOn(const Mode& mode);
    void start();
    void stop();
    [[nodiscard]] Outcome dequeue(bool errorSeen);

    VideoNode node_;
    Agreed agreed_;
    PixelWay way_ = PixelWay::Copied;
    std::shared_ptr<CaptureBuffers> buffers_;
};

} // namespace autostereo::devices::v4l2

#pragma once

#include "devices/v4l2/frame_clock.hpp"
#include "devices/v4l2/video_node.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace autostereo::devices::v4l2 {

/// What the driver agreed to; may differ from what was asked for.
struct Agreed {
    Mode mode;
    std::size_t stride = 0; ///< bytes from row to row of the first plane
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

/// A running capture stream over mapped buffers: set up and started by construction, stopped by
/// destruction. Movable, thread-bound.
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

    [[nodiscard]] const Agreed& agreed() const { return agreed_; }
    [[nodiscard]] const VideoNode& node() const { return node_; }

  private:
    class Mapping {
      public:
        Mapping(int fd, std::size_t length, std::int64_t offset);
        Mapping(Mapping&& other) noexcept;
        Mapping& operator=(Mapping&&) = delete;
        Mapping(const Mapping&) = delete;
        Mapping& operator=(const Mapping&) = delete;
        ~Mapping();
        [[nodiscard]] std::span<const std::byte> bytes() const { return {data_, length_}; }

      private:
        std::byte* data_ = nullptr;
        std::size_t length_ = 0;
    };

    void agreeOn(const Mode& mode);
    void mapBuffers();
    void start();
    [[nodiscard]] int queue(std::uint32_t buffer);
    [[nodiscard]] Outcome dequeue(bool errorSeen);

    VideoNode node_;
    Agreed agreed_;
    std::vector<Mapping> buffers_;
    std::vector<std::uint32_t> refused_; ///< could not be queued; tried again
};

} // namespace autostereo::devices::v4l2

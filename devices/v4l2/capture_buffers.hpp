#pragma once

#include "devices/pixel_sharing.hpp"
#include "devices/v4l2/video_node.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace autostereo::devices::v4l2 {

/// What the rows of a picture take in a driver's buffer.
struct BufferShape {
    std::size_t rowBytes = 0;
    std::size_t rows = 0;
    std::size_t pictureBytes = 0; ///< of the driver's, no less than its rows
};

/// The buffers of a running stream, in the driver's memory or the GPU's, mapped for reading. They
/// outlive the stream as long as one of them is lent. The thread of the stream owns it; what was
/// lent comes back on any thread.
class CaptureBuffers : public std::enable_shared_from_this<CaptureBuffers> {
  public:
    /// Asks the driver for its own, `exported`: as dmabufs too. Throws DeviceError.
    [[nodiscard]] static std::shared_ptr<CaptureBuffers> drivers(const VideoNode& node,
                                                                 bool exported);
    /// Of a GPU's memory. Throws DeviceError, std::runtime_error where there is none.
    [[nodiscard]] static std::shared_ptr<CaptureBuffers>
    filled(const VideoNode& node, PixelMemory& memory, const BufferShape& shape);

    CaptureBuffers(const CaptureBuffers&) = delete;
    CaptureBuffers& operator=(const CaptureBuffers&) = delete;
    ~CaptureBuffers();

    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(all_.size()); }
    /// V4L2_MEMORY_ of them.
    [[nodiscard]] std::uint32_t memory() const { return memory_; }
    [[nodiscard]] std::span<const std::byte> bytes(std::uint32_t index) const;
    /// Gives it to the driver: 0, or errno.
    [[nodiscard]] int queue(const VideoNode& node, std::uint32_t index);
    /// Every one that neither the driver nor anybody else has; those refused wait for the next
    /// turn.
    void queueFree(const VideoNode& node);
    /// How many the driver has.
    [[nodiscard]] std::uint32_t queued() const;
    /// The driver gave it back: it is the caller's until it is released or the last holder of what
    /// `lend` made is gone.
    void take(std::uint32_t index);
    void release(std::uint32_t index);
    /// Of a buffer that was taken and has a dmabuf.
    [[nodiscard]] std::shared_ptr<const SharedPixels> lend(std::uint32_t index,
                                                           std::shared_ptr<PixelSharing> sharing,
                                                           PixelWay way, std::size_t rowBytes);

  private:
    class Mapping {
      public:
        Mapping() = default;
        Mapping(int fd, std::size_t length, std::int64_t offset);
        Mapping(const Mapping&) = delete;
        Mapping& operator=(const Mapping&) = delete;
        ~Mapping();
        [[nodiscard]] std::span<const std::byte> bytes() const { return {data_, length_}; }

      private:
        std::byte* data_ = nullptr;
        std::size_t length_ = 0;
    };
    struct Buffer {
        UniqueFd dmabuf; ///< none: not shared
        std::unique_ptr<Mapping> mapping;
        bool queued = false;
        std::atomic<bool> taken{false};
    };
    struct Lease;

    explicit CaptureBuffers(std::uint32_t memory);
    void synchronise(const Buffer& buffer, bool begin) const;

    std::uint32_t memory_;
    std::uint64_t set_;
    std::vector<std::unique_ptr<Buffer>> all_;
};

} // namespace autostereo::devices::v4l2

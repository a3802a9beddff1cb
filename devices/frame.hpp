#pragma once

#include "devices/clock.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace autostereo::devices {

enum class PixelFormat : std::uint8_t {
    Depth16, ///< host-endian uint16 counts of `depthUnitM` along the optical axis; 0, 65535: none
    // Colour, 8 bits a sample, gamma-encoded as the camera gave it.
    Rgba8, ///< R, G, B, 255
    Bgra8, ///< B, G, R, any
    Rgb8,  ///< V4L2's RGB24
    Bgr8,
    Grey8,
    Yuyv, ///< Y Cb Y Cr: two pixels share their chroma
    Uyvy, ///< Cb Y Cr Y
    Nv12, ///< all Y, then rows of Cb Cr, of which four pixels share one
};

/// Of tightly packed rows. Sides have to be as `allowsSize` wants them.
[[nodiscard]] constexpr std::size_t frameBytes(PixelFormat format, int width, int height) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    switch (format) {
    case PixelFormat::Grey8:
        return pixels;
    case PixelFormat::Nv12:
        return pixels / 2 * 3;
    case PixelFormat::Depth16:
    case PixelFormat::Yuyv:
    case PixelFormat::Uyvy:
        return pixels * 2;
    case PixelFormat::Rgb8:
    case PixelFormat::Bgr8:
        return pixels * 3;
    case PixelFormat::Rgba8:
    case PixelFormat::Bgra8:
        break;
    }
    return pixels * 4;
}

/// Shared chroma needs even sides.
[[nodiscard]] constexpr bool allowsSize(PixelFormat format, int width, int height) {
    const bool pairs = format == PixelFormat::Yuyv || format == PixelFormat::Uyvy;
    const bool blocks = format == PixelFormat::Nv12;
    return width >= 1 && height >= 1 && (!(pairs || blocks) || width % 2 == 0) &&
           (!blocks || height % 2 == 0);
}

/// How Y, Cb and Cr stand for colours. Auto: BT.709 from 720 rows on, BT.601 below; limited range.
enum class YuvMatrix : std::uint8_t { Auto, Bt601, Bt709 };
enum class YuvRange : std::uint8_t {
    Auto,
    Limited, ///< Y 16..235, Cb and Cr 16..240
    Full,    ///< 0..255, as in JPEG
};

struct FrameMetadata {
    PixelFormat format = PixelFormat::Rgba8;
    int width = 0; ///< pixels; rows are tightly packed, top row first
    int height = 0;
    std::uint64_t sequence = 0; ///< per stream; gaps are frames the source lost
    TimePoint capturedAt{};     ///< middle of the exposure
    TimePoint arrivedAt{};      ///< live: on the host, whole; else not set
    double depthUnitM = 0.001;  ///< metres per count, Depth16 only
    YuvMatrix matrix = YuvMatrix::Auto;
    YuvRange range = YuvRange::Auto;
    bool hasAmplitude = false;    ///< Depth16: a uint16 IR amplitude plane follows the depth
    std::size_t encodedBytes = 0; ///< colour: of the JPEG that it came as, kept behind the pixels
    bool encodedMirrored = false; ///< that JPEG's columns run the other way than the pixels'
};

struct SharedPixels;

/// One picture from one sensor, holding a lease on a slot of its source's FramePool, or on a buffer
/// that a driver filled, whose pixels can only be read. Movable, not copyable; destruction gives
/// the slot back, on any thread. It may outlive its source and the pool. Reentrant.
class Frame {
  public:
    /// Where a lease returns to; implemented by FramePool.
    class Owner {
      public:
        virtual void release(std::size_t slot) noexcept = 0;

      protected:
        ~Owner() = default;
    };

    Frame() = default;
    Frame(Owner& owner, std::size_t slot, std::span<std::byte> storage, FrameMetadata metadata)
        : owner_(&owner), slot_(slot), storage_(storage), metadata_(metadata) {}
    /// In a driver's buffer, which goes back with the last holder of `shared`.
    Frame(std::span<std::byte> storage, FrameMetadata metadata,
          std::shared_ptr<const SharedPixels> shared)
        : storage_(storage), metadata_(metadata), shared_(std::move(shared)) {}
    Frame(Frame&& other) noexcept { swap(other); }
    Frame& operator=(Frame&& other) noexcept {
        Frame(std::move(other)).swap(*this);
        return *this;
    }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;
    ~Frame() {
        if (owner_ != nullptr) owner_->release(slot_);
    }

    [[nodiscard]] bool empty() const { return owner_ == nullptr && !shared_; }
    [[nodiscard]] const FrameMetadata& metadata() const { return metadata_; }
    [[nodiscard]] FrameMetadata& metadata() { return metadata_; }
    [[nodiscard]] std::size_t pixelCount() const {
        return static_cast<std::size_t>(metadata_.width) *
               static_cast<std::size_t>(metadata_.height);
    }

    /// `frameBytes` of them, top row first.
    [[nodiscard]] std::span<const std::byte> pixels() const { return storage_.first(byteCount()); }
    [[nodiscard]] std::span<std::byte> pixels() { return storage_.first(byteCount()); }
    [[nodiscard]] std::span<const std::uint16_t> depth() const { return plane16(0); }
    [[nodiscard]] std::span<std::uint16_t> depth() { return plane16(0); }
    /// How the GPU may come to the pixels without a copy (devices/pixel_sharing.hpp); none: not at
    /// all.
    [[nodiscard]] const std::shared_ptr<const SharedPixels>& shared() const { return shared_; }
    void setShared(std::shared_ptr<const SharedPixels> shared) { shared_ = std::move(shared); }
    /// As the camera sent it, for recordings; empty where that is what `pixels` holds.
    [[nodiscard]] std::span<const std::byte> encoded() const {
        return storage_.subspan(byteCount(), metadata_.encodedBytes);
    }
    [[nodiscard]] std::span<std::byte> encoded() {
        return storage_.subspan(byteCount(), metadata_.encodedBytes);
    }
    /// Empty where the sensor has none.
    [[nodiscard]] std::span<const std::uint16_t> amplitude() const {
        return metadata_.hasAmplitude ? plane16(1) : std::span<std::uint16_t>{};
    }
    [[nodiscard]] std::span<std::uint16_t> amplitude() {
        return metadata_.hasAmplitude ? plane16(1) : std::span<std::uint16_t>{};
    }

  private:
    void swap(Frame& other) noexcept {
        std::swap(owner_, other.owner_);
        std::swap(slot_, other.slot_);
        std::swap(storage_, other.storage_);
        std::swap(metadata_, other.metadata_);
        std::swap(shared_, other.shared_);
    }
    [[nodiscard]] std::size_t byteCount() const {
        return frameBytes(metadata_.format, metadata_.width, metadata_.height);
    }
    [[nodiscard]] std::span<std::uint16_t> plane16(std::size_t plane) const {
        // Slots are allocated with the alignment of max_align_t, so the cast is to aligned storage.
        auto* first = reinterpret_cast<std::uint16_t*>(storage_.data());
        return {first + plane * pixelCount(), pixelCount()};
    }

    Owner* owner_ = nullptr;
    std::size_t slot_ = 0;
    std::span<std::byte> storage_;
    FrameMetadata metadata_;
    std::shared_ptr<const SharedPixels> shared_;
};

/// One depth and one colour frame that belong together.
struct RgbdFrame {
    Frame depth;
    Frame color;
    std::uint64_t index = 0; ///< counts pairs from 0
};

} // namespace autostereo::devices

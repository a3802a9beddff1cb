#pragma once

#include "tests/device/usbip/device.hpp"

#include <array>
#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace autostereo::test {

/// One format that the camera offers, with one size.
struct UvcFormat {
    enum class Kind : std::uint8_t { Yuyv, Mjpeg };
    Kind kind = Kind::Yuyv;
    int width = 640;
    int height = 480;
    /// MJPEG: pictures that are sent in turn. YUYV: made by the camera.
    std::vector<usbip::Bytes> jpegs;
};

struct UvcParams {
    std::vector<UvcFormat> formats{UvcFormat{}};
    bool isochronous = false; ///< else bulk
    std::vector<unsigned> framesPerSecond{30, 15, 5};
    std::string product = "Emulated camera";
    std::string serial = "UVC0001";
};

/// What the camera itself does wrong; counted in frames since the stream began, 0: never.
struct UvcFaults {
    unsigned errorEvery = 0;  ///< carries UVC's error bit
    unsigned halfEvery = 0;   ///< breaks off in the middle, without the error bit
    unsigned silentAfter = 0; ///< sends nothing more until it is plugged in again
    bool refuses = false;     ///< stalls what it is asked to commit to
    bool absurdSizes = false; ///< promises frames of 4 GiB
    /// Bits turned over in what it says about itself when it is plugged in, all by this seed; 0:
    /// none.
    unsigned damagedDescriptors = 0;
};

/// A USB video class 1.1 camera (high speed) on `usbip`, which the kernel's uvcvideo binds. Frames
/// come at the negotiated rate; frame n is all `lumaOf(n)`, its chroma neutral. Faults may be
/// set by any thread.
class UvcCamera final : public usbip::Device {
  public:
    static constexpr std::uint8_t kVideo = 0x81; ///< the endpoint

    explicit UvcCamera(UvcParams params);

    void setFaults(const UvcFaults& faults);
    [[nodiscard]] unsigned framesSent() const { return framesSent_.load(); }
    /// What the host has set a control to: {entity << 8 | selector}.
    [[nodiscard]] long control(unsigned which) const;

    [[nodiscard]] static std::uint8_t lumaOf(unsigned frame) {
        return static_cast<std::uint8_t>(16 + frame % 200);
    }

    [[nodiscard]] usbip::Descriptors descriptors() const override;
    [[nodiscard]] std::optional<usbip::Bytes> control(const usbip::Setup& setup,
                                                      std::span<const std::uint8_t> data) override;
    void setInterface(std::uint8_t interface, std::uint8_t alternate) override;
    void clearHalt(std::uint8_t endpoint) override;
    [[nodiscard]] usbip::Answer read(std::uint8_t endpoint, std::size_t capacity,
                                     usbip::Time now) override;
    [[nodiscard]] usbip::Bytes readInterval(std::uint8_t endpoint, std::size_t capacity,
                                            usbip::Time interval) override;

  private:
    /// What host and camera agree on, by UVC's numbers, which start at 1.
    struct Agreement {
        std::uint8_t format = 1;
        std::uint8_t frame = 1;
        std::uint32_t interval = 0; ///< 100 ns
    };
    struct Control {
        unsigned bytes;
        long least, most, standard, now;
    };

    [[nodiscard]] std::optional<usbip::Bytes> streaming(const usbip::Setup& setup,
                                                        std::span<const std::uint8_t> data);
    [[nodiscard]] std::optional<usbip::Bytes> setting(const usbip::Setup& setup,
                                                      std::span<const std::uint8_t> data);
    [[nodiscard]] usbip::Bytes agreementBytes(const Agreement& agreement) const;
    [[nodiscard]] std::uint32_t frameBytes(const UvcFormat& format) const;
    void agree(Agreement& agreement, std::span<const std::uint8_t> wanted) const;
    void startStream();
    /// Begins the next frame if one is due; false: not yet.
    [[nodiscard]] bool begin(usbip::Time now);
    [[nodiscard]] usbip::Bytes payload(std::size_t capacity);

    UvcParams params_;
    mutable std::mutex mutex_;
    UvcFaults faults_;                     ///< under mutex_
    std::map<unsigned, Control> settings_; ///< under mutex_; by {entity << 8 | selector}
    Agreement probe_, commit_;
    std::atomic<unsigned> framesSent_{0};
    bool streaming_ = false;
    unsigned frame_ = 0; ///< of this stream
    usbip::Time nextFrame_{};
    usbip::Bytes picture_;
    std::size_t sent_ = 0; ///< bytes of picture_
    bool inFrame_ = false;
    bool error_ = false; ///< this frame carries the error bit
};

} // namespace autostereo::test

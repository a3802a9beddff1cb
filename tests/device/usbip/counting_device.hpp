#pragma once

#include "tests/device/usbip/device.hpp"

#include <chrono>
#include <mutex>

namespace autostereo::test {

/// The simplest device with one endpoint of each type: all data count up, byte by byte, modulo 256,
/// packet after packet. An example of how a device is written.
class CountingDevice final : public usbip::Device {
  public:
    static constexpr std::uint8_t kBulkIn = 0x81, kBulkOut = 0x02, kInterruptIn = 0x83,
                                  kIsochronousIn = 0x84;
    static constexpr std::uint16_t kVendor = 0x1209, kProduct = 0x0002;
    static constexpr std::size_t kPacketBytes = 512;
    static constexpr std::uint8_t kEcho = 0x21; ///< vendor request: what was written last

    [[nodiscard]] usbip::Descriptors descriptors() const override {
        usbip::Descriptors all;
        all.device = {18, 1, 0x00, 0x03, 0xff, 0, 0, 9, 0x09, 0x12, 2, 0, 0, 1, 1, 2, 3, 1};
        all.strings = {{1, "autostereo"}, {2, "Counting device"}, {3, "C1"}};
        all.capabilities = usbip::superSpeedCapabilities();
        usbip::Bytes& bytes = all.configuration = usbip::configurationHeader(1);
        using usbip::EndpointType;
        usbip::put(bytes, usbip::interfaceDescriptor(0, 0, 4, {}));
        const auto add = [&](usbip::Endpoint endpoint, unsigned most, unsigned intervalBytes) {
            usbip::put(bytes, usbip::endpointDescriptor(endpoint, most));
            usbip::put(bytes, usbip::companionDescriptor(0, 0, intervalBytes));
        };
        add({kBulkIn, EndpointType::Bulk, 0}, 1024, 0);
        add({kBulkOut, EndpointType::Bulk, 0}, 1024, 0);
        add({kInterruptIn, EndpointType::Interrupt, 4}, 64, 64);
        add({kIsochronousIn, EndpointType::Isochronous, 1}, 1024, 1024);
        usbip::finishConfiguration(bytes);
        return all;
    }

    [[nodiscard]] std::optional<usbip::Bytes> control(const usbip::Setup& setup,
                                                      std::span<const std::uint8_t>) override {
        if (setup.request != kEcho) return std::nullopt;
        const std::lock_guard lock(mutex_);
        return written_;
    }

    [[nodiscard]] usbip::Answer read(std::uint8_t endpoint, std::size_t capacity,
                                     usbip::Time now) override {
        if (endpoint == kBulkIn)
            return usbip::Answer::with(count(std::min(capacity, kPacketBytes)));
        if (now < nextInterrupt_) return usbip::Answer::later(nextInterrupt_);
        nextInterrupt_ = now + std::chrono::milliseconds(20);
        return usbip::Answer::with(count(8));
    }

    [[nodiscard]] usbip::Answer write(std::uint8_t, std::span<const std::uint8_t> data,
                                      usbip::Time) override {
        const std::lock_guard lock(mutex_);
        written_.assign(data.begin(), data.end());
        return usbip::Answer::taken();
    }

    [[nodiscard]] usbip::Bytes readInterval(std::uint8_t, std::size_t capacity,
                                            usbip::Time) override {
        return count(std::min(capacity, kPacketBytes));
    }

  private:
    usbip::Bytes count(std::size_t bytes) {
        usbip::Bytes packet(bytes);
        for (std::uint8_t& byte : packet)
            byte = next_++;
        return packet;
    }

    std::mutex mutex_;
    usbip::Bytes written_; ///< under mutex_
    std::uint8_t next_ = 0;
    usbip::Time nextInterrupt_{};
};

} // namespace autostereo::test

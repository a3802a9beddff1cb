#pragma once

#include "devices/clock.hpp"
#include "devices/unique_fd.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

struct libusb_context;
struct libusb_device_handle;

namespace autostereo::devices::kinect2 {

/// An open USB device. Its node is opened here and handed to libusb, which then does not watch for
/// plugs: a device that it has seen go would make libusb 1.0.26 abort in `setAlternate`. All
/// functions throw DeviceError, one line. Once the device is gone they touch it no more.
/// Thread-bound.
class UsbLink {
  public:
    /// Claims `interfaces` of them, from 0 on.
    UsbLink(const std::filesystem::path& node, int interfaces);
    ~UsbLink();
    UsbLink(const UsbLink&) = delete;
    UsbLink& operator=(const UsbLink&) = delete;

    void setAlternate(int interface, int alternate);
    /// A standard request without data; what a device refuses is no error.
    void request(std::uint8_t recipient, std::uint8_t request, std::uint16_t value,
                 std::uint16_t index);
    /// Bulk.
    void write(std::uint8_t endpoint, std::span<const std::byte> bytes, Duration patience);
    /// Bulk, `most` bytes or a short packet; empty when nothing came in time.
    [[nodiscard]] std::vector<std::byte> read(std::uint8_t endpoint, std::size_t most,
                                              Duration patience);

    /// Whether transfers have ended, or all of them will, that `handleEvents` has not looked at.
    [[nodiscard]] bool somethingEnded() const;
    /// Lets streams' transfers end, for so long at most.
    void handleEvents(Duration atMost);

    /// Why it can be used no more; nothing: it can.
    [[nodiscard]] const std::optional<std::string>& lost() const { return lost_; }
    void lose(std::string reason);

    [[nodiscard]] libusb_device_handle* handle() const { return handle_.get(); }

  private:
    struct ContextFreer {
        void operator()(libusb_context* context) const noexcept;
    };
    struct HandleFreer {
        void operator()(libusb_device_handle* handle) const noexcept;
    };
    [[noreturn]] void fail(const std::string& tried, const std::string& why) const;
    /// Libusb's answer; below 0 it throws, and a device that is gone is remembered as such.
    int check(int answer, const char* tried);
    void checkNotLost(const char* tried) const;

    std::string node_;
    UniqueFd fd_;
    std::unique_ptr<libusb_context, ContextFreer> context_;
    std::unique_ptr<libusb_device_handle, HandleFreer> handle_;
    int claimed_ = 0;
    std::optional<std::string> lost_;
};

} // namespace autostereo::devices::kinect2

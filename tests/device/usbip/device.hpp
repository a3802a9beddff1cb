#pragma once

#include "tests/device/usbip/bytes.hpp"
#include "tests/device/usbip/descriptors.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace autostereo::test::usbip {

using Time = std::chrono::steady_clock::time_point;

/// The eight bytes that start a control transfer.
struct Setup {
    std::uint8_t requestType = 0;
    std::uint8_t request = 0;
    std::uint16_t value = 0;
    std::uint16_t index = 0;
    std::uint16_t length = 0;

    [[nodiscard]] bool toHost() const { return (requestType & 0x80U) != 0; }
    [[nodiscard]] bool standard() const { return (requestType & 0x60U) == 0; }
};

/// What a device has for one bulk or interrupt transfer.
struct Answer {
    enum class Kind : std::uint8_t { Data, Later, Stall };
    Kind kind = Kind::Stall;
    Bytes data; ///< IN only; shorter than the transfer: a short packet ends it
    Time askAgain{};

    [[nodiscard]] static Answer with(Bytes data) { return {Kind::Data, std::move(data), {}}; }
    [[nodiscard]] static Answer taken() { return {Kind::Data, {}, {}}; }
    /// Not before `time`, or before the host's next request if that comes first.
    [[nodiscard]] static Answer later(Time time) { return {Kind::Later, {}, time}; }
    [[nodiscard]] static Answer stall() { return {}; }
};

/// A USB device as a program: derive from this, then plug it in with `Plug`. The kernel, usbfs and
/// libusb cannot tell it from hardware.
///
/// - `descriptors` says what the device is; which endpoints there are and of what type is read from
///   them. They are read once, when it is plugged in.
/// - Standard requests are answered by the plug; `control` gets class and vendor requests, and
///   `setInterface` hears of alternate settings.
/// - IN transfers wait until the device has data: `read` is asked when one arrives, after any other
///   request, and at the time that it named.
/// - Isochronous endpoints are asked for one service interval at a time (125 us x 2^(bInterval -
/// 1)),
///   in step with the clock; an interval without data is an empty packet.
/// - Faults on the wire (lost, truncated, doubled packets, silence, unplugging) are the plug's
///   business: see `Faults`. Faults in what the device says are the device's own.
///
/// All calls come from the plug's thread. A device that other threads talk to locks for itself.
class Device {
  public:
    virtual ~Device() = default;

    [[nodiscard]] virtual Descriptors descriptors() const = 0;

    /// A class or vendor request with the data that came with it. To the host: its answer (cut to
    /// what was asked for), from it: anything. Nothing: a stall.
    [[nodiscard]] virtual std::optional<Bytes> control(const Setup& setup,
                                                       std::span<const std::uint8_t> data) = 0;

    virtual void setInterface(std::uint8_t /*interface*/, std::uint8_t /*alternate*/) {}

    /// The host cleared the halt of an endpoint: UVC cameras with bulk endpoints stop so.
    virtual void clearHalt(std::uint8_t /*endpoint*/) {}

    /// Bulk or interrupt IN, `capacity` bytes at most.
    [[nodiscard]] virtual Answer read(std::uint8_t /*endpoint*/, std::size_t /*capacity*/,
                                      Time /*now*/) {
        return Answer::stall();
    }

    /// Bulk or interrupt OUT.
    [[nodiscard]] virtual Answer write(std::uint8_t /*endpoint*/,
                                       std::span<const std::uint8_t> /*data*/, Time /*now*/) {
        return Answer::stall();
    }

    /// The host let an isochronous endpoint go without a transfer since `ended`. From when it is
    /// listened to again, now or later, as host controllers please.
    [[nodiscard]] virtual Time resumeAt(std::uint8_t /*endpoint*/, Time /*ended*/, Time now) {
        return now;
    }

    /// Isochronous IN: what the interval that starts at `interval` carries.
    [[nodiscard]] virtual Bytes readInterval(std::uint8_t /*endpoint*/, std::size_t /*capacity*/,
                                             Time /*interval*/) {
        return {};
    }
};

} // namespace autostereo::test::usbip

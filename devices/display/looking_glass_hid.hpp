#pragma once

#include "devices/clock.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace autostereo::devices {

/// USB HID reports of one first-generation Looking Glass (8.9", 15.6"). Thread-bound.
class HidTransport {
  public:
    static constexpr std::size_t kReportBytes = 68;
    using Report = std::array<std::byte, kReportBytes>;

    virtual ~HidTransport() = default;
    /// Sends a request, with its report number 0 in front, and waits for the next reply. Nothing:
    /// none of 68 bytes came by `deadline`. Throws DeviceError when the display has gone.
    [[nodiscard]] virtual std::optional<Report> exchange(const Report& request,
                                                         TimePoint deadline) = 0;
};

/// How long to try. A page takes a few milliseconds, a calibration has about 30 pages.
struct HidPatience {
    int attempts = 4; ///< for each page
    Duration reply = std::chrono::milliseconds(250);
    Duration whole = std::chrono::seconds(10);
};

/// The calibration's JSON text, page by page, 1 byte to 64 KiB; its numbers are not looked at.
/// Lost replies and those of other pages are asked for again. Throws DeviceError: no answer, pages
/// that never match, a length that cannot be, no JSON.
[[nodiscard]] std::string readHidCalibration(HidTransport& transport, const Clock& clock,
                                             const HidPatience& patience = {});

/// The same from replies that were recorded, 68 bytes each, in the order in which they came; a
/// shorter rest at the end is dropped. Takes any bytes.
[[nodiscard]] std::string calibrationFromReplies(std::span<const std::byte> replies);

} // namespace autostereo::devices

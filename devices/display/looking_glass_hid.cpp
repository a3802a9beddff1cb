#include "devices/display/looking_glass_hid.hpp"

#include "devices/input.hpp"

#include <algorithm>

namespace autostereo::devices {

namespace {

using Report = HidTransport::Report;

// Request: report number, command 0 (read a page), page (big-endian), 64 bytes of nothing.
// Reply: buttons, command, page, 64 bytes of it.
constexpr std::size_t kHeaderBytes = 4;
constexpr std::size_t kPageBytes = HidTransport::kReportBytes - kHeaderBytes;
constexpr std::size_t kLengthBytes = 4; // in front of the text, in page 0
constexpr std::size_t kLongestText = 64U << 10U;

[[noreturn]] void fail(const std::string& why) {
    throw DeviceError("looking glass (USB 04d8:ef7e): cannot read its calibration: " + why);
}

Report requestFor(std::size_t page) {
    Report request{};
    request[2] = static_cast<std::byte>(page >> 8U);
    request[3] = static_cast<std::byte>(page & 0xffU);
    return request;
}

bool answers(const Report& reply, const Report& request) {
    return std::equal(reply.begin() + 1, reply.begin() + kHeaderBytes, request.begin() + 1);
}

/// Asks for pages and keeps to the limits.
class PageReader {
  public:
    PageReader(HidTransport& transport, const Clock& clock, const HidPatience& patience)
        : transport_(transport), clock_(clock), patience_(patience),
          end_(clock.now() + patience.whole) {}

    [[nodiscard]] Report read(std::size_t page) {
        const Report request = requestFor(page);
        std::string last = "no answer";
        for (int attempt = 0; attempt < patience_.attempts; ++attempt) {
            const TimePoint now = clock_.now();
            if (now >= end_) break;
            const auto reply = transport_.exchange(request, std::min(end_, now + patience_.reply));
            if (reply && answers(*reply, request)) return *reply;
            // A reply to an earlier request that had been given up: the right one comes after it.
            last = reply ? "answers to other pages" : "no answer";
        }
        fail("page " + std::to_string(page) + ": " + last +
             " (unplug the display's USB cable and plug it in again)");
    }

  private:
    HidTransport& transport_;
    const Clock& clock_;
    const HidPatience& patience_;
    TimePoint end_;
};

std::size_t lengthIn(const Report& first) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < kLengthBytes; ++i)
        length = length << 8U | std::to_integer<std::size_t>(first[kHeaderBytes + i]);
    if (length == 0) fail("it is empty (unplug the display's USB cable and plug it in again)");
    if (length > kLongestText)
        fail("its length is " + std::to_string(length) + " bytes (allowed 1 to 65536)");
    return length;
}

/// Replies one after the other, whatever is asked.
class RecordedReplies final : public HidTransport {
  public:
    explicit RecordedReplies(std::span<const std::byte> replies) : rest_(replies) {}

    [[nodiscard]] std::optional<Report> exchange(const Report&, TimePoint) override {
        if (rest_.size() < kReportBytes) return std::nullopt;
        Report reply{};
        std::copy_n(rest_.begin(), kReportBytes, reply.begin());
        rest_ = rest_.subspan(kReportBytes);
        return reply;
    }

  private:
    std::span<const std::byte> rest_;
};

class StoppedClock final : public Clock {
  public:
    [[nodiscard]] TimePoint now() const noexcept override { return {}; }
    void sleepUntil(TimePoint) noexcept override {}
};

} // namespace

std::string readHidCalibration(HidTransport& transport, const Clock& clock,
                               const HidPatience& patience) {
    PageReader pages(transport, clock, patience);
    Report page = pages.read(0);
    const std::size_t length = lengthIn(page);
    std::string text;
    text.reserve(length + kPageBytes);
    std::size_t skip = kHeaderBytes + kLengthBytes;
    for (std::size_t number = 1;; ++number) {
        std::transform(page.begin() + static_cast<std::ptrdiff_t>(skip), page.end(),
                       std::back_inserter(text),
                       [](std::byte byte) { return static_cast<char>(byte); });
        if (text.size() >= length) break;
        page = pages.read(number);
        skip = kHeaderBytes;
    }
    text.resize(length);
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos || text[first] != '{')
        fail("what the display holds is no JSON (unplug its USB cable and plug it in again)");
    return text;
}

std::string calibrationFromReplies(std::span<const std::byte> replies) {
    RecordedReplies transport(replies);
    const StoppedClock clock;
    return readHidCalibration(transport, clock);
}

} // namespace autostereo::devices

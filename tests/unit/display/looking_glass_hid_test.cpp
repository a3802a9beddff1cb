#include "devices/display/looking_glass_hid.hpp"

#include "devices/display/usb_hid.hpp"
#include "devices/input.hpp"
#include "tests/support/fake_clock.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

namespace autostereo::test {
namespace {

using namespace devices;
using Report = HidTransport::Report;
using Bytes = std::vector<std::byte>;

const std::string kText =
    R"({"serial":"LKG-2K-01338","pitch":{"value":49.91},"slope":{"value":5.8},)"
    R"("center":{"value":0},"DPI":{"value":338},"screenW":{"value":2560}})";

/// A display with this memory: length, then text. `meddle` may change a reply, or lose it.
class FakeDisplay final : public HidTransport {
  public:
    using Meddle = std::function<std::optional<Report>(int exchange, std::size_t page, Report)>;

    explicit FakeDisplay(const std::string& text, FakeClock& clock, Meddle meddle = {})
        : clock_(clock), meddle_(std::move(meddle)) {
        for (const unsigned shift : {24U, 16U, 8U, 0U})
            memory.push_back(static_cast<std::byte>(text.size() >> shift & 0xffU));
        for (const char c : text)
            memory.push_back(static_cast<std::byte>(c));
    }

    std::optional<Report> exchange(const Report& request, TimePoint deadline) override {
        EXPECT_GT(deadline, clock_.now());
        EXPECT_EQ(std::to_integer<int>(request[0]), 0);
        EXPECT_EQ(std::to_integer<int>(request[1]), 0);
        const std::size_t page = std::to_integer<std::size_t>(request[2]) << 8U |
                                 std::to_integer<std::size_t>(request[3]);
        Report reply = request;
        reply[0] = std::byte{0x05}; // two buttons are held
        for (std::size_t i = 0; i < 64; ++i)
            reply[4 + i] = 64 * page + i < memory.size() ? memory[64 * page + i] : std::byte{0xff};
        const int number = exchanges++;
        const auto result = meddle_ ? meddle_(number, page, reply) : reply;
        if (!result) clock_.sleepUntil(deadline);
        return result;
    }

    Bytes memory;
    int exchanges = 0;

  private:
    FakeClock& clock_;
    Meddle meddle_;
};

class LookingGlassHid : public testing::Test {
  protected:
    std::string read(HidTransport& display) const { return readHidCalibration(display, clock); }
    std::string errorOf(HidTransport& display) const {
        try {
            return "no error: " + read(display);
        } catch (const DeviceError& error) {
            return error.what();
        }
    }
    FakeClock clock;
};

TEST_F(LookingGlassHid, ReadsTextsOfAnyLength) {
    for (const std::size_t size : {2U, 59U, 60U, 61U, 123U, 124U, 125U, 4000U, 65536U}) {
        std::string text = kText;
        text.resize(size, ' ');
        FakeDisplay display(text, clock);
        EXPECT_EQ(read(display), text);
        EXPECT_EQ(display.exchanges, static_cast<int>((size + 4 + 63) / 64));
    }
}

TEST_F(LookingGlassHid, LostRepliesAreAskedForAgain) {
    FakeDisplay display(kText, clock, [](int number, std::size_t, Report reply) {
        return number % 3 == 2 ? std::optional(reply) : std::nullopt;
    });
    EXPECT_EQ(read(display), kText);
}

TEST_F(LookingGlassHid, RepliesThatComeLateAreToldByTheirPage) {
    std::optional<Report> late;
    FakeDisplay display(kText, clock, [&](int, std::size_t, const Report& reply) {
        return std::exchange(late, reply); // always the one before
    });
    EXPECT_EQ(read(display), kText);
}

TEST_F(LookingGlassHid, AnotherCommandIsNoAnswer) {
    FakeDisplay display(kText, clock, [](int number, std::size_t page, Report reply) {
        if (number % 2 == 0) reply[1] = std::byte{1};
        if (page == 1 && number % 2 == 0) reply[2] = std::byte{1};
        return std::optional(reply);
    });
    EXPECT_EQ(read(display), kText);
}

TEST_F(LookingGlassHid, GivesUpOnASilentDisplay) {
    FakeDisplay display(kText, clock, [](int, std::size_t, Report) { return std::nullopt; });
    const TimePoint start = clock.now();
    EXPECT_NE(errorOf(display).find("page 0: no answer"), std::string::npos);
    EXPECT_EQ(display.exchanges, HidPatience{}.attempts);
    EXPECT_LE(clock.now() - start, std::chrono::seconds(2));
}

TEST_F(LookingGlassHid, GivesUpOnPagesThatNeverMatch) {
    FakeDisplay display(kText, clock, [](int, std::size_t page, Report reply) {
        if (page == 1) reply[3] = std::byte{7};
        return std::optional(reply);
    });
    EXPECT_NE(errorOf(display).find("page 1: answers to other pages"), std::string::npos);
    EXPECT_EQ(display.exchanges, 1 + HidPatience{}.attempts);
}

TEST_F(LookingGlassHid, ASlowDisplayHasOnlySoMuchTime) {
    std::string text = kText;
    text.resize(60000, ' ');
    FakeDisplay display(text, clock, [&](int, std::size_t, const Report& reply) {
        clock.advance(std::chrono::milliseconds(100));
        return std::optional(reply);
    });
    EXPECT_NE(errorOf(display).find("page 100: no answer"), std::string::npos);
}

TEST_F(LookingGlassHid, LengthsThatCannotBe) {
    const auto errorWith = [&](std::initializer_list<unsigned> length) {
        FakeDisplay display(kText, clock);
        std::transform(length.begin(), length.end(), display.memory.begin(),
                       [](unsigned byte) { return static_cast<std::byte>(byte); });
        return errorOf(display);
    };
    EXPECT_NE(errorWith({0, 0, 0, 0}).find("it is empty"), std::string::npos);
    EXPECT_NE(errorWith({0, 1, 0, 1}).find("its length is 65537"), std::string::npos);
    EXPECT_NE(errorWith({255, 255, 255, 255}).find("allowed 1 to 65536"), std::string::npos);
}

TEST_F(LookingGlassHid, AllZerosAndBlankMemory) {
    FakeDisplay zeros(kText, clock, [](int, std::size_t, Report) { return Report{}; });
    EXPECT_NE(errorOf(zeros).find("plug it in again"), std::string::npos);
    FakeDisplay blank(std::string(200, '\0'), clock);
    EXPECT_NE(errorOf(blank).find("no JSON"), std::string::npos);
}

Bytes record(const std::string& text) {
    FakeClock clock;
    Bytes replies;
    FakeDisplay display(text, clock, [&](int, std::size_t, const Report& reply) {
        replies.insert(replies.end(), reply.begin(), reply.end());
        return std::optional(reply);
    });
    (void)readHidCalibration(display, clock);
    return replies;
}

TEST_F(LookingGlassHid, RecordedReplies) {
    const Bytes replies = record(kText);
    EXPECT_EQ(calibrationFromReplies(replies), kText);
    for (std::size_t size = 0; size < replies.size(); ++size)
        EXPECT_THROW((void)calibrationFromReplies(std::span(replies).first(size)), DeviceError);
}

TEST_F(LookingGlassHid, DamagedReplies) {
    std::mt19937 random(11);
    const Bytes whole = record(kText);
    for (int round = 0; round < 300; ++round) {
        Bytes replies = whole;
        for (int flips = 1 + round % 5; flips > 0; --flips)
            replies[random() % replies.size()] ^= static_cast<std::byte>(1U << random() % 8);
        try {
            EXPECT_LE(calibrationFromReplies(replies).size(), 65536U);
        } catch (const DeviceError& error) {
            EXPECT_NE(std::string(error.what()), "");
        }
    }
}

/// Where a display of the first generation is connected, its text must look like one.
TEST(UsbHid, FindsADisplayOrNone) {
    const auto display = openLookingGlassHid();
    EXPECT_EQ(openLookingGlassHid(100), nullptr);
    if (!display) GTEST_SKIP() << "no first-generation Looking Glass on USB";
    const SteadyClock clock;
    EXPECT_NE(readHidCalibration(*display, clock).find("pitch"), std::string::npos);
}

} // namespace
} // namespace autostereo::test

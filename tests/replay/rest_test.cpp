// Hours and visitors: when the cameras work but nothing is to be shown.

#include "tests/replay/kiosk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <ctime>

namespace autostereo::test {
namespace {

using std::chrono::milliseconds;

/// Opening hours on another day than today and its neighbours.
std::string otherDays() {
    constexpr std::array kDays{"sun", "mon", "tue", "wed", "thu", "fri", "sat"};
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    return std::string("rest.hours = [\"") + kDays.at((local.tm_wday + 3U) % 7) +
           " 09:00-18:00\"]\n";
}

TEST(Rest, OutsideOfItsHoursThePanelIsBlackTillTheyAreChanged) {
    Kiosk kiosk(otherDays());
    kiosk.plugBoth();
    kiosk.start({"--report", kiosk.folder() / "report.json"});
    ASSERT_TRUE(kiosk.shows("closed", milliseconds(5000)));
    EXPECT_TRUE(eventually(
        [&] {
            const auto rgb = kiosk.snapshot().rgb;
            return std::ranges::count(rgb, 0) == static_cast<std::ptrdiff_t>(rgb.size());
        },
        milliseconds(1000 * kSlower)));
    // It is closed before the cameras' first pair is there.
    EXPECT_TRUE(eventually([&] { return kiosk.status().at("report").at("frames_skipped") > 0; },
                           milliseconds(2000 * kSlower)));
    kiosk.configure("");
    ASSERT_TRUE(succeeded(kiosk.command({"reload"})));
    ASSERT_TRUE(kiosk.shows("live", milliseconds(1000)));
    EXPECT_GT(contrast(kiosk.snapshot()), 10);
    EXPECT_TRUE(succeeded(kiosk.stop()));
    const auto report = readReport(kiosk.folder() / "report.json");
    EXPECT_TRUE(balanced(report));
    EXPECT_GT(report.accounts.skipped, 0U);
}

TEST(Rest, WithNobodyThereTheIdlePictureStandsTillSomebodyComes) {
    // The simulated room has nothing within 30 cm, and somebody within three metres.
    const std::string nobody = "rest.presence_m = 0.3\nrest.leave_s = 0.2\n";
    Kiosk kiosk(nobody);
    kiosk.plugBoth();
    kiosk.start({"--report", kiosk.folder() / "report.json"});
    ASSERT_TRUE(kiosk.shows("nobody", milliseconds(5000)));
    EXPECT_TRUE(eventually([&] { return kiosk.snapshot() == plainMessage(""); },
                           milliseconds(1000 * kSlower)))
        << "the idle picture without words";
    kiosk.configure("rest.presence_m = 3\nrest.leave_s = 0.2\n");
    ASSERT_TRUE(succeeded(kiosk.command({"reload"})));
    ASSERT_TRUE(kiosk.shows("live", milliseconds(1000)));
    EXPECT_GT(contrast(kiosk.snapshot()), 10);

    // A camera that is lost is said to be, though nobody is there.
    kiosk.configure(nobody + "idle.freeze_s = 0.2\n");
    ASSERT_TRUE(succeeded(kiosk.command({"reload"})));
    ASSERT_TRUE(kiosk.shows("nobody", milliseconds(2000)));
    kiosk.unplug("depth");
    kiosk.unplug("color");
    EXPECT_TRUE(kiosk.shows("idle", milliseconds(4000)));
    EXPECT_TRUE(succeeded(kiosk.stop()));
    const auto report = readReport(kiosk.folder() / "report.json");
    EXPECT_TRUE(balanced(report));
    EXPECT_GT(report.accounts.skipped, 0U);
}

} // namespace
} // namespace autostereo::test

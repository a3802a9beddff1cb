// Sensors that come late, go, fall silent and come back: the panel is never black without a reason.

#include "tests/replay/kiosk.hpp"
#include "tests/replay/notify_socket.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace autostereo::test {
namespace {

using std::chrono::milliseconds;

TEST(Idle, WithoutACameraThereIsAPictureThatSaysSo) {
    Kiosk kiosk("messages.no_input = \"Kaputt: wählen Sie 123\"\n");
    const auto started = std::chrono::steady_clock::now();
    kiosk.start();
    EXPECT_LT(std::chrono::steady_clock::now() - started, milliseconds(2000 * kSlower));
    EXPECT_EQ(kiosk.status().value("shown", ""), "idle") << "from the first moment";
    EXPECT_GT(contrast(kiosk.snapshot()), 10) << "words in front of something dark";
    ASSERT_TRUE(
        eventually([&] { return kiosk.status().value("message", "") == "Kaputt: wählen Sie 123"; },
                   milliseconds(3000 * kSlower)));
    EXPECT_EQ(kiosk.snapshot(), plainMessage("Kaputt: wählen Sie 123"));
    EXPECT_NE(kiosk.status().value("input_problem", "").find("depth"), std::string::npos);

    kiosk.plugBoth();
    EXPECT_TRUE(kiosk.shows("live", milliseconds(1500)));
    EXPECT_TRUE(
        eventually([&] { return kiosk.snapshot() != plainMessage("Kaputt: wählen Sie 123"); },
                   milliseconds(1000)));
    const ProgramResult result = kiosk.stop();
    EXPECT_TRUE(succeeded(result));
    EXPECT_NE(result.err.find("panel: Kaputt"), std::string::npos) << "the journal knows, too";
}

TEST(Idle, WithoutDepthColourIsShownFlatThenLiveAgain) {
    Kiosk kiosk("idle.freeze_s = 0.3\n");
    kiosk.plugBoth();
    kiosk.start({"--report", kiosk.folder() / "report.json"});
    ASSERT_TRUE(kiosk.shows("live", milliseconds(5000)));
    kiosk.unplug("depth");
    ASSERT_TRUE(kiosk.shows("color-alone", milliseconds(2000)));
    const auto lost = kiosk.status();
    EXPECT_EQ(lost.at("sensors").at("depth").at("state"), "lost");
    EXPECT_EQ(lost.at("sensors").at("depth").at("reason"), "depth camera unplugged");
    EXPECT_EQ(lost.at("sensors").at("color").at("state"), "streaming");
    EXPECT_EQ(lost.at("report").at("depth").at("scale"), 0.0) << "everything in the panel's plane";

    kiosk.plug("depth");
    EXPECT_TRUE(kiosk.shows("live", milliseconds(1500)))
        << "half a second to look for it, and some";
    EXPECT_GT(kiosk.status().at("report").at("depth").at("scale"), 0.0);
    EXPECT_TRUE(succeeded(kiosk.stop()));
    EXPECT_TRUE(balanced(readReport(kiosk.folder() / "report.json")));
}

TEST(Idle, WithoutColourTheLastPictureStaysForAShortTime) {
    constexpr int kFreezeS = 4; // two snapshots are taken in it, under a sanitizer too
    Kiosk kiosk("idle.freeze_s = " + std::to_string(kFreezeS) + "\n");
    kiosk.plugBoth();
    kiosk.start();
    ASSERT_TRUE(kiosk.shows("live", milliseconds(5000)));
    kiosk.unplug("color");
    ASSERT_TRUE(kiosk.shows("frozen", milliseconds(1500)));
    const ColorPicture frozen = kiosk.snapshot();
    EXPECT_GT(contrast(frozen), 10);
    EXPECT_EQ(frozen, kiosk.snapshot());
    ASSERT_TRUE(kiosk.shows("idle", milliseconds(1000 * (kFreezeS + 2))));
    EXPECT_EQ(kiosk.snapshot(), plainMessage("The colour camera does not answer"));
    kiosk.unplug("depth");
    EXPECT_TRUE(eventually(
        [&] { return kiosk.status().value("message", "") == "The cameras do not answer"; },
        milliseconds(1500 * kSlower)));
    kiosk.plugBoth();
    EXPECT_TRUE(kiosk.shows("live", milliseconds(1500)));
    EXPECT_TRUE(succeeded(kiosk.stop()));
}

TEST(Idle, ASilentCameraIsMissedAndTheIdlePictureIsTheOnesOfTheConfiguration) {
    Kiosk kiosk("idle.freeze_s = 0\nidle.content = \"idle.png\"\nmessages.both_lost = \"\"\n");
    (void)writeColor(kiosk.folder() / "idle.png", kSmallWidth, kSmallHeight, [](int x, int y) {
        return Rgb{static_cast<std::uint8_t>(x / 2), static_cast<std::uint8_t>(y), 77};
    });
    kiosk.plugBoth();
    kiosk.start();
    ASSERT_TRUE(kiosk.shows("live", milliseconds(5000)));
    kiosk.silence("depth");
    kiosk.silence("color");
    ASSERT_TRUE(kiosk.shows("idle", milliseconds(2000)));
    ASSERT_TRUE(eventually([&] { return kiosk.status().value("message", "x").empty(); },
                           milliseconds(1000 * kSlower)));
    EXPECT_EQ(kiosk.snapshot(), readColor(kiosk.folder() / "idle.png"));
    kiosk.plugBoth();
    EXPECT_TRUE(kiosk.shows("live", milliseconds(1000)));
    EXPECT_TRUE(succeeded(kiosk.stop()));
}

TEST(Idle, IdlePicturesFeedTheWatchdog) {
    Kiosk kiosk;
    NotifySocket socket(kiosk.folder() / "notify");
    kiosk.start({}, {"NOTIFY_SOCKET=" + socket.path(), "WATCHDOG_USEC=1500000"});
    for (int i = 0; i < 3; ++i)
        EXPECT_TRUE(socket.waitFor("WATCHDOG=1", milliseconds(1500 * kSlower)));
    EXPECT_TRUE(succeeded(kiosk.stop()));
}

TEST(Idle, WhatWaitingCannotMendEndsTheProgram) {
    const TempFolder folder;
    for (const auto& [uri, code] : {std::pair{"sim:nowhere", 2}, {"ftp:somewhere", 2}}) {
        const std::string config = folder.file("c.toml", "input.wait = \"yes\"\ninput.uri = \"" +
                                                             std::string(uri) + "\"\n");
        EXPECT_TRUE(
            failedPlainly(runProgram(calling({"run", "--config", config, "--display",
                                              smallDisplay(folder), "--output", "offscreen"})),
                          code));
    }
}

} // namespace
} // namespace autostereo::test

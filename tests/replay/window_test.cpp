#include "tests/replay/program.hpp"
#include "tests/replay/x_server.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

namespace autostereo::test {
namespace {

constexpr const char* kShownDisplay = "slanted-8view-1080p";

class Window : public testing::Test {
  protected:
    void SetUp() override {
        const auto missing = XServer::missing();
        if (!missing) return;
        if (required("xvfb")) FAIL() << *missing;
        GTEST_SKIP() << *missing;
    }

    /// One frame, over and over: the window's picture stays.
    [[nodiscard]] std::vector<std::string> still(std::vector<std::string> more) const {
        std::vector<std::string> arguments{
            "run",       "--input",     std::string(kSmallRoom) + "&noise=off&frames=1",
            "--display", kShownDisplay, "--speed",
            "max"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
    [[nodiscard]] static ProgramCall on(const XServer& server, std::vector<std::string> arguments) {
        auto call = calling(std::move(arguments));
        call.environment = {"DISPLAY=" + server.display(), "WAYLAND_DISPLAY="};
        return call;
    }
    TempFolder folder;
};

TEST_F(Window, CoversTheMonitorWithThePanelBitForBit) {
    ASSERT_TRUE(succeeded(
        runProgram(calling(still({"--output", "offscreen", "--snapshot", folder / "panel.png"})))));
    const ColorPicture panel = readColor(folder / "panel.png");

    const XServer server(1920, 1080);
    RunningProgram program(on(server, still({"--report", folder / "report.json"})));
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30 * kSlower);
    ColorPicture screen = server.screenshot();
    while (screen != panel && program.running() && std::chrono::steady_clock::now() < deadline) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        screen = server.screenshot();
    }
    ASSERT_EQ(screen.width, panel.width);
    ASSERT_EQ(screen.height, panel.height);
    EXPECT_EQ(compareImages(screen.view(), panel.view()).max, 0)
        << compareImages(screen.view(), panel.view());

    program.signal(SIGTERM);
    EXPECT_TRUE(succeeded(program.wait()));
    const RunReport report = readReport(folder / "report.json");
    EXPECT_TRUE(balanced(report));
    EXPECT_EQ(report.accounts.presented, 1U) << "a picture that stays is drawn once";
}

TEST_F(Window, KeepsScreenSaverAndPointerAway) {
    const XServer server(1920, 1080);
    const int usual = server.screenSaverTimeout();
    ASSERT_GT(usual, 0) << "else nothing would be seen here";
    ASSERT_TRUE(server.pointerVisible());
    RunningProgram program(on(server, still({})));
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30 * kSlower);
    const auto undisturbed = [&] {
        return server.screenSaverTimeout() == 0 && !server.pointerVisible();
    };
    while (!undisturbed() && program.running() && std::chrono::steady_clock::now() < deadline)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(server.screenSaverTimeout(), 0);
    EXPECT_FALSE(server.pointerVisible());

    program.signal(SIGTERM);
    EXPECT_TRUE(succeeded(program.wait()));
    EXPECT_EQ(server.screenSaverTimeout(), usual) << "the machine is left as it was";
    EXPECT_TRUE(server.pointerVisible());
}

TEST_F(Window, PreviewTakesWhateverModeTheMonitorHas) {
    const XServer server(800, 600);
    const std::string snapshot = folder / "panel.png";
    ASSERT_TRUE(
        succeeded(runProgram(on(server, {"run", "--input", kSmallRoom, "--display", "preview",
                                         "--frames", "1", "--snapshot", snapshot}))));
    EXPECT_EQ(readColor(snapshot).width, 800);
    EXPECT_EQ(readColor(snapshot).height, 600);
}

TEST_F(Window, AMonitorInAnotherModeIsRefusedUnlessForced) {
    const XServer server(1280, 720);
    const ProgramResult refused = runProgram(on(server, still({"--frames", "1"})));
    EXPECT_TRUE(failedPlainly(refused, 3));
    EXPECT_NE(refused.err.find("1280x720"), std::string::npos) << refused.err;
    EXPECT_NE(refused.err.find("--force"), std::string::npos) << refused.err;
    EXPECT_TRUE(succeeded(runProgram(on(server, still({"--frames", "1", "--force"})))));
}

TEST_F(Window, WithoutADisplayServerIsNotFound) {
    const auto window = still({"--output", "window", "--frames", "1"});
    EXPECT_TRUE(failedPlainly(runProgram(calling(window)), 3));
    auto call = calling(window);
    call.environment = {"DISPLAY=:4711", "WAYLAND_DISPLAY="}; // nobody's
    EXPECT_TRUE(failedPlainly(runProgram(call), 3));
}

} // namespace
} // namespace autostereo::test

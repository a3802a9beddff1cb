// A display's numbers set by eye: keys on the panel, the picture that follows them, the file.

#include "config/load.hpp"
#include "tests/replay/program.hpp"
#include "tests/replay/x_server.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <thread>

namespace autostereo::test {
namespace {

constexpr const char* kTunedDisplay = "slanted-8view-1080p";

class TuneDisplay : public testing::Test {
  protected:
    void SetUp() override {
        const auto missing = XServer::missing();
        if (missing && required("xvfb")) FAIL() << *missing;
        if (missing) GTEST_SKIP() << *missing;
        server.emplace(1920, 1080);
        auto call = calling({"calibrate", "display", "--keys", "--display", kTunedDisplay,
                             "--output", folder / "mine.toml"});
        call.environment = {"DISPLAY=" + server->display(), "WAYLAND_DISPLAY="};
        program.emplace(call);
    }
    /// Whether the program says this within half a minute.
    bool says(const std::string& text) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30 * kSlower);
        while (program->out().find(text) == std::string::npos) {
            if (std::chrono::steady_clock::now() > end) return false;
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        return true;
    }
    [[nodiscard]] std::string saved() const {
        std::ifstream file(folder / "mine.toml");
        return {std::istreambuf_iterator<char>(file), {}};
    }

    TempFolder folder;
    std::optional<XServer> server;
    std::optional<RunningProgram> program;
};

TEST_F(TuneDisplay, KeysMoveThePictureAndAreSaved) {
    if (IsSkipped()) return;
    ASSERT_TRUE(says("lens.subpixels_per_lens")) << program->err();
    const double start =
        std::get<calib::VanBerkelLens>(config::loadDisplay(kTunedDisplay).law).subpixelsPerLens;
    server->press({"Right", "Right", "Right", "u", "Next", "Left"}); // +2 spans, -1 tenth
    server->press({"Down", "Down", "Right"});
    ASSERT_TRUE(says("lens.offset_subpixels"));
    server->press({"t"});
    // Without the strip of text the panel's lowest row is black between its lines.
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30 * kSlower);
    ColorPicture before = server->screenshot();
    while (before.rgb[before.rgb.size() - 3] > 0 && std::chrono::steady_clock::now() < end)
        before = server->screenshot();
    server->press({"s"});
    const ProgramResult result = program->wait();
    ASSERT_TRUE(succeeded(result));
    const calib::DisplayProfile mine = config::loadDisplay(folder / "mine.toml");
    const auto lens = std::get<calib::VanBerkelLens>(mine.law);
    EXPECT_NEAR(lens.subpixelsPerLens, start * (1 + 1.9e-3), 1e-9);
    EXPECT_EQ(mine.provenance.at("subpixels_per_lens"), "measured");
    EXPECT_EQ(mine.provenance.contains("row_shift_subpixels") &&
                  mine.provenance.at("row_shift_subpixels") == "measured",
              false)
        << "it was left alone";
    // What was on the panel is what the file makes of it.
    ASSERT_TRUE(succeeded(runProgram(calling({"pattern", "lines", "--display", folder / "mine.toml",
                                              "--output", folder / "lines.png"}))));
    EXPECT_EQ(readColor(folder / "lines.png"), before);
}

TEST_F(TuneDisplay, WhoLeavesChangesNothing) {
    if (IsSkipped()) return;
    ASSERT_TRUE(says("lens.subpixels_per_lens")) << program->err();
    server->press({"Right", "Escape"});
    const ProgramResult result = program->wait();
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.out.find("nothing saved"), std::string::npos);
    EXPECT_TRUE(saved().empty());
}

TEST_F(TuneDisplay, NoStepLeavesTheRange) {
    if (IsSkipped()) return;
    ASSERT_TRUE(says("lens.subpixels_per_lens")) << program->err();
    server->press({"Up", "Prior"}); // the last number: the fan, in steps of half of itself
    ASSERT_TRUE(says("viewing.cone_deg"));
    server->press({"Left", "Left", "Left", "Left"});
    EXPECT_TRUE(says("allowed")) << program->out();
    EXPECT_TRUE(program->running());
}

} // namespace
} // namespace autostereo::test

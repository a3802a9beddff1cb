// What a configuration names for when there is nothing to show and nothing to say.

#include "tests/replay/kiosk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace autostereo::test {
namespace {

using std::chrono::milliseconds;

/// The simulated room has nothing within 30 cm, and somebody within three metres.
constexpr const char* kNobody = "rest.presence_m = 0.3\nrest.leave_s = 0.2\n";

std::string showing(const std::string& file) { return "idle.content = \"" + file + "\"\n"; }

bool showsSoon(const Kiosk& kiosk, const ColorPicture& wanted) {
    return eventually([&] { return kiosk.snapshot() == wanted; }, milliseconds(2000 * kSlower));
}

void comesBack(const Kiosk& kiosk) {
    kiosk.configure("rest.presence_m = 3\nrest.leave_s = 0.2\n");
    ASSERT_TRUE(succeeded(kiosk.command({"reload"})));
    EXPECT_TRUE(kiosk.shows("live", milliseconds(1000)));
}

TEST(IdleContent, AQuiltIsShownAsInterleaveDoes) {
    Kiosk kiosk(showing("castle_qs4x2a1.78.png") + kNobody);
    const std::string quilt =
        writeColor(kiosk.folder() / "castle_qs4x2a1.78.png", 4 * kSmallTileWidth,
                   2 * kSmallTileHeight, [](int x, int y) {
                       const int view = x / kSmallTileWidth + 4 * (1 - y / kSmallTileHeight);
                       return Rgb{static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                                  static_cast<std::uint8_t>(30 * view)};
                   });
    const std::string panel = kiosk.folder() / "panel.png";
    ASSERT_TRUE(succeeded(runProgram(calling({"interleave", "--quilt", quilt, "--display",
                                              smallDisplay(kiosk.folder()), "--output", panel}))));
    kiosk.plugBoth();
    kiosk.start();
    ASSERT_TRUE(kiosk.shows("nobody", milliseconds(5000)));
    EXPECT_TRUE(showsSoon(kiosk, readColor(panel)));
    comesBack(kiosk);
    EXPECT_TRUE(succeeded(kiosk.stop()));
}

/// So that a picture does not depend on how often the recording was shown before.
constexpr const char* kFrameAlone = "condition.hold = false\nfusion.remember = false\n"
                                    "depth.focus_m = 1.5\ndepth.scale = 1\n"
                                    "synthesis.keep_roots = false\n";
constexpr int kRecorded = 6;

/// As they are where the recording is the input.
std::vector<ColorPicture> framesPlayed(const Kiosk& kiosk, const std::string& recording) {
    const std::string look = kiosk.folder().file("look.toml", kFrameAlone);
    std::vector<ColorPicture> frames;
    constexpr int kOnTheirWay = 2; // a busy machine had taken more when the last was counted
    for (int count = 1; count <= kRecorded + kOnTheirWay; ++count) {
        const std::string panel = kiosk.folder() / "panel.png";
        EXPECT_TRUE(succeeded(
            runProgram(calling({"run", "--config", look, "--input", recording, "--display",
                                smallDisplay(kiosk.folder()), "--output", "offscreen", "--frames",
                                std::to_string(count), "--speed", "max", "--snapshot", panel}))));
        frames.push_back(readColor(panel));
    }
    return frames;
}

/// Which of the frames a picture shows; -1: none. A slow machine leaves frames out, and colours
/// that are made up behind things remember the frames before within 2 % (HELD in
/// shaders/push.comp): 60 dB where it does. Two frames are 29 dB alike at most.
std::ptrdiff_t frameIn(const ColorPicture& shown, const std::vector<ColorPicture>& frames) {
    constexpr double kSameDb = 40;
    const auto found = std::ranges::find_if(
        frames, [&](const ColorPicture& frame) { return psnr(shown, frame) >= kSameDb; });
    return found == frames.end() ? -1 : found - frames.begin();
}

/// Which of the frames are on the panel within a time that shows all of them; -1: something
/// else is.
std::vector<std::ptrdiff_t> framesSeen(const Kiosk& kiosk,
                                       const std::vector<ColorPicture>& frames) {
    std::vector<std::ptrdiff_t> seen;
    for (int i = 0; i < 8; ++i) {
        seen.push_back(frameIn(kiosk.snapshot(), frames));
    }
    std::ranges::sort(seen);
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    return seen;
}

TEST(IdleContent, ARecordingPlaysOverAndOverAndIsNeverLive) {
    Kiosk kiosk(showing("visit.mkv") + kNobody + kFrameAlone +
                "messages.both_lost = \"\"\nidle.freeze_s = 0.2\n");
    const std::string recording = kiosk.folder() / "visit.mkv";
    ASSERT_TRUE(succeeded(
        runProgram(calling({"record", "--input", std::string(kSmallPerson) + "&seed=5&fps=5",
                            "--frames", std::to_string(kRecorded), "--output", recording}))));
    const auto frames = framesPlayed(kiosk, recording);
    kiosk.plugBoth();
    kiosk.start();
    ASSERT_TRUE(kiosk.shows("nobody", milliseconds(5000)));
    ASSERT_TRUE(eventually([&] { return frameIn(kiosk.snapshot(), frames) >= 0; },
                           milliseconds(2000 * kSlower)));
    const auto before = kiosk.status();
    const auto seen = framesSeen(kiosk, frames);
    EXPECT_GE(seen.front(), 0) << "something else was shown";
    EXPECT_GE(seen.size(), 2U) << "it stands still";
    const auto after = kiosk.status();
    EXPECT_EQ(after.at("shown"), "nobody");
    EXPECT_EQ(after.at("report").at("frames_presented"),
              before.at("report").at("frames_presented"));

    // Nor where the cameras are gone and nothing is said about it.
    kiosk.unplug("depth");
    kiosk.unplug("color");
    ASSERT_TRUE(kiosk.shows("idle", milliseconds(4000)));
    EXPECT_GE(framesSeen(kiosk, frames).front(), 0);
    EXPECT_EQ(kiosk.status().at("shown"), "idle");
    kiosk.plugBoth();
    comesBack(kiosk);
    EXPECT_TRUE(succeeded(kiosk.stop()));
}

void writeRoof(const Kiosk& kiosk) {
    (void)kiosk.folder().file("roof.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0.5\nv 0 -1 1\n"
                                          "f 1 4 3\nf 4 2 3\n");
}

TEST(IdleContent, ASceneIsShownAsItIsAsAnInput) {
    Kiosk kiosk(showing("roof.obj") + kNobody +
                "scene.turn_s = 0\nmessages.both_lost = \"gone\"\nidle.freeze_s = 0.2\n");
    writeRoof(kiosk);
    kiosk.plugBoth();
    kiosk.start();
    ASSERT_TRUE(kiosk.shows("nobody", milliseconds(5000)));
    const std::string alone = kiosk.folder() / "alone.png";
    const std::string look = kiosk.folder().file("look.toml", "scene.turn_s = 0\n");
    ASSERT_TRUE(succeeded(
        runProgram(calling({"run", "--config", look, "--input", kiosk.folder() / "roof.obj",
                            "--display", smallDisplay(kiosk.folder()), "--output", "offscreen",
                            "--frames", "1", "--speed", "max", "--snapshot", alone}))));
    EXPECT_TRUE(showsSoon(kiosk, readColor(alone)));
    // Words go before it, and visitors.
    kiosk.unplug("depth");
    kiosk.unplug("color");
    EXPECT_TRUE(eventually([&] { return kiosk.snapshot() == plainMessage("gone"); },
                           milliseconds(4000 * kSlower)));
    EXPECT_TRUE(succeeded(kiosk.stop()));
}

TEST(IdleContent, ASceneTurns) {
    Kiosk kiosk(showing("roof.obj") + kNobody + "scene.turn_s = 2\n");
    writeRoof(kiosk);
    kiosk.plugBoth();
    kiosk.start();
    ASSERT_TRUE(kiosk.shows("nobody", milliseconds(5000)));
    EXPECT_TRUE(eventually([&] { return kiosk.snapshot() != plainMessage(""); },
                           milliseconds(1000 * kSlower)));
    const ColorPicture before = kiosk.snapshot();
    EXPECT_TRUE(
        eventually([&] { return kiosk.snapshot() != before; }, milliseconds(500 * kSlower)));
    comesBack(kiosk);
    EXPECT_TRUE(succeeded(kiosk.stop()));
}

/// Files that are not what their names say, or not there; a quilt with more tiles than pixels.
constexpr std::array kBad{"broken.mkv", "broken.oni",      "broken.png",      "gone.png",
                          "gone.obj",   "small_qs9x9.png", "broken_qs4x2.png"};

void writeBad(const TempFolder& folder) {
    for (const char* name : {"broken.mkv", "broken.oni", "broken.png", "broken_qs4x2.png"})
        (void)folder.file(name, "nothing");
    (void)writeColor(folder / "small_qs9x9.png", 8, 8, [](int, int) { return Rgb{1, 2, 3}; });
}

TEST(IdleContent, WhatCannotBeShownIsSaidAndLeftOut) {
    const std::string silent = "messages.no_input = \"\"\nmessages.starting = \"\"\n";
    Kiosk kiosk(silent);
    writeBad(kiosk.folder());
    kiosk.start();
    for (const char* name : kBad) {
        kiosk.configure(silent + showing(name));
        ASSERT_TRUE(succeeded(kiosk.command({"reload"})));
        EXPECT_TRUE(showsSoon(kiosk, plainMessage(""))) << name;
    }
    const ProgramResult result = kiosk.stop();
    EXPECT_EQ(result.exitCode, 0);
    for (const char* name : kBad) {
        const auto said = result.err.find(name);
        ASSERT_NE(said, std::string::npos) << name << '\n' << result.err;
        const auto line = result.err.rfind('\n', said) + 1;
        EXPECT_EQ(result.err.substr(line, 15), "[warning] idle:") << result.err;
    }
}

/// One line each, with the configuration's name.
TEST(IdleContent, CheckSaysWhatCannotBeShown) {
    const TempFolder folder;
    writeBad(folder);
    for (const char* name : kBad) {
        const std::string config = folder.file("kiosk.toml", showing(name));
        const ProgramResult result = runProgram(calling({"check", config}));
        EXPECT_EQ(result.exitCode, 2) << name;
        EXPECT_EQ(result.err.find(config + ": idle.content: "), 0U) << result.err;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    }
}

TEST(IdleContent, AFileThatGoesWhileTheProgramRunsIsLeftOut) {
    Kiosk kiosk(showing("visit.mkv") + "messages.both_lost = \"\"\nidle.freeze_s = 0.2\n");
    const std::string recording = kiosk.folder() / "visit.mkv";
    ASSERT_TRUE(succeeded(runProgram(
        calling({"record", "--input", kSmallPerson, "--frames", "2", "--output", recording}))));
    kiosk.plugBoth();
    kiosk.start();
    ASSERT_TRUE(kiosk.shows("live", milliseconds(5000)));
    std::filesystem::remove(recording);
    kiosk.unplug("depth");
    kiosk.unplug("color");
    ASSERT_TRUE(kiosk.shows("idle", milliseconds(4000)));
    EXPECT_TRUE(showsSoon(kiosk, plainMessage("")));
    const ProgramResult result = kiosk.stop();
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.err.find("[warning] idle: "), std::string::npos) << result.err;
}

} // namespace
} // namespace autostereo::test

// Recordings that the program makes: other programs read them, kills and full disks spare them.

#include "devices/input.hpp"
#include "tests/replay/program.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <random>
#include <thread>

namespace autostereo::test {
namespace {

using namespace std::chrono_literals;

std::uintmax_t sizeOf(const std::string& file) {
    std::error_code ignored;
    const auto size = std::filesystem::file_size(file, ignored);
    return ignored ? 0 : size;
}

std::string bytesOf(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Media time of a stream's last frame, and how many there are.
struct Played {
    std::uint64_t frames = 0;
    devices::Duration last{0};
};

Played play(devices::Source& source) {
    Played played;
    for (;;) {
        auto result = source.read(devices::TimePoint::max());
        const auto* frame = std::get_if<devices::Frame>(&result);
        if (frame == nullptr) return played;
        ++played.frames;
        played.last = frame->metadata().capturedAt.time_since_epoch();
    }
}

/// A program of another package, where it is installed.
std::optional<ProgramResult> tool(const std::string& name, std::vector<std::string> arguments) {
    const std::string path = "/usr/bin/" + name;
    if (!std::filesystem::exists(path)) return std::nullopt;
    return runProgram({path, std::move(arguments), {}, {}, 60s, {}});
}

TEST(Record, TheInputItselfIsNotWrittenOver) {
    const TempFolder folder;
    const std::string file = folder / "r.mkv";
    ASSERT_TRUE(succeeded(runProgram(calling(
        {"record", "--input", std::string(kSmallPerson) + "&frames=5", "--output", file}))));
    const std::string before = bytesOf(file);
    const std::string sameFile = folder / "./r.mkv";
    for (const auto& command :
         {std::vector<std::string>{"record", "--input", file, "--output", sameFile},
          {"record", "--input", kSmallPerson, "--color", file, "--output", sameFile},
          {"run", "--input", file, "--record", sameFile, "--output", "offscreen"}}) {
        const ProgramResult result = runProgram(calling(command));
        EXPECT_EQ(result.exitCode, 2) << result.err;
        EXPECT_NE(result.err.find("it is the input itself"), std::string::npos) << result.err;
        EXPECT_EQ(bytesOf(file), before);
    }
}

TEST(Record, OtherProgramsReadIt) {
    const TempFolder folder;
    const std::string file = folder / "r.mkv";
    ASSERT_TRUE(
        succeeded(runProgram(calling({"record", "--input", std::string(kSmallPerson) + "&frames=20",
                                      "--speed", "max", "--output", file}))));
    const auto probed =
        tool("ffprobe", {"-v", "error", "-count_packets", "-show_entries",
                         "stream=codec_name,width,height,nb_read_packets", "-of", "csv=p=0", file});
    if (!probed) {
        if (required("ffprobe")) FAIL() << "ffprobe is not installed";
        GTEST_SKIP() << "ffprobe is not installed";
    }
    EXPECT_EQ(probed->err, "");
    EXPECT_NE(probed->out.find("320,180,20"), std::string::npos) << probed->out;
    EXPECT_NE(probed->out.find("176,144,20"), std::string::npos) << probed->out;
    const auto info = tool("mkvinfo", {file});
    ASSERT_TRUE(info) << "mkvinfo is not installed";
    for (const char* wanted : {"Name: COLOR", "Name: DEPTH", "Name: IR", "\"b16g\"", "\"BGRA\"",
                               "K4A_DEPTH_MODE", "camera.json", "Duration: 00:00:00.6"})
        EXPECT_NE(info->out.find(wanted), std::string::npos) << wanted << "\n" << info->out;
}

TEST(Record, WhatIsShownIsRecorded) {
    const TempFolder folder;
    const std::string file = folder / "r.mkv", report = folder / "r.json";
    ASSERT_TRUE(succeeded(runProgram(
        calling({"run", "--input", std::string(kSmallPerson) + "&frames=10", "--display",
                 smallDisplay(folder), "--output", "offscreen", "--speed", "max", "--record", file,
                 "--snapshot", folder / "first.png", "--report", report}))));
    // Shown again, the recording gives the same last picture.
    ASSERT_TRUE(succeeded(
        runProgram(calling({"run", "--input", file, "--display", smallDisplay(folder), "--output",
                            "offscreen", "--speed", "max", "--snapshot", folder / "again.png"}))));
    EXPECT_EQ(bytesOf(folder / "first.png"), bytesOf(folder / "again.png"));
    EXPECT_EQ(readReport(report).accounts.framesIn, 10U);
}

TEST(Record, AKillLosesNoMoreThanTheLastSecond) {
    const int kills = fullCampaign() ? 100 : 4;
    std::mt19937 random(20261122);
    constexpr auto kPeriod = 100ms; // a simulated camera that a busy machine keeps up with
    for (int i = 0; i < kills; ++i) {
        SCOPED_TRACE(i);
        const TempFolder folder;
        const std::string file = folder / "k.mkv";
        const auto lived = std::chrono::milliseconds(random() % 2500);
        RunningProgram program(calling(
            {"record", "--input", std::string(kSmallPerson) + "&fps=10", "--output", file}));
        constexpr std::uintmax_t kHead = 16'384; // less than the first picture
        const auto limit = std::chrono::steady_clock::now() + 30s;
        while (sizeOf(file) < kHead && std::chrono::steady_clock::now() < limit)
            std::this_thread::sleep_for(5ms);
        ASSERT_GE(sizeOf(file), kHead) << "nothing was recorded";
        std::this_thread::sleep_for(lived);
        program.signal(SIGKILL);
        EXPECT_EQ(program.wait().exitCode, 128 + SIGKILL);

        const devices::Input input = devices::openInput(file);
        ASSERT_TRUE(input.depth);
        const Played depth = play(*input.depth);
        EXPECT_GE(depth.frames, 1U);
        EXPECT_GE(depth.last, lived - 1s - kPeriod * kSlower);
        EXPECT_TRUE(input.rig);
    }
}

TEST(Record, AFullDiskEndsTheRecordingAndNotThePicture) {
    const TempFolder folder;
    const std::string file = folder / "f.mkv", report = folder / "r.json";
    const ProgramCall plain = calling({"run", "--input", std::string(kSmallPerson) + "&frames=40",
                                       "--display", smallDisplay(folder), "--output", "offscreen",
                                       "--speed", "max", "--record", file, "--report", report});
    ProgramCall limited = plain;
    limited.program = "/bin/bash";
    limited.arguments = {"-c", "trap '' XFSZ; ulimit -f 2000; exec \"$0\" \"$@\"",
                         plain.program.string()};
    limited.arguments.insert(limited.arguments.end(), plain.arguments.begin(),
                             plain.arguments.end());
    const ProgramResult result = runProgram(limited);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.err.find("cannot record to " + file + ": File too large: the recording ends"),
              std::string::npos)
        << result.err;
    EXPECT_EQ(readReport(report).accounts.presented, 40U);
    const devices::Input input = devices::openInput(file);
    const Played color = play(*input.color);
    EXPECT_GE(color.frames, 5U); // 2000 KiB hold six pictures of 225 KiB and as many depths
    EXPECT_LE(color.frames, 8U);
}

} // namespace
} // namespace autostereo::test

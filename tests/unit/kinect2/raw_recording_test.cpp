// What a unit sends, recorded below the decoder and played back.

#include "devices/kinect2/raw/raw_input.hpp"
#include "devices/kinect2/raw/raw_reader.hpp"
#include "devices/kinect2/raw/raw_recorder.hpp"
#include "devices/kinect2/unit_frames.hpp"
#include "tests/support/kinect2_unit.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <thread>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace autostereo::test {
namespace {

using namespace devices::kinect2;
using devices::TimePoint;
using namespace std::chrono_literals;

const UnitPages& pages() {
    static const UnitPages kPages = [] {
        const Kinect2Unit unit = inventedUnit();
        return UnitPages{"000001234567", "4.0.3903", phasePage(unit), depthCameraPage(unit),
                         colorPage(unit)};
    }();
    return kPages;
}

/// Frame `number` as a camera sends it; what it shows depends on the number.
RawDepthFrame exposure(std::uint32_t number) {
    std::mt19937_64 random(number);
    const auto scene = [&](int x, int) { return LitPoint{800.0 + x + 10 * number, 600}; };
    RawDepthFrame frame = expose(inventedUnit(), scene, 0, random);
    frame.sequence = 70 + number;
    frame.timestamp = 267 * number;
    return frame;
}

void send(RawTap& tap, const RawDepthFrame& frame, TimePoint time) {
    for (const Bytes& packet : depthPackets(frame)) {
        tap.depth(packet, true, packet.empty() ? TimePoint{} : time);
        if (packet.empty()) tap.depth({}, true, {}); // as on a bus that is idle
    }
}

/// Three frames from second 50 on.
const std::array<RawDepthFrame, 3>& frames() {
    static const std::array<RawDepthFrame, 3> kFrames{exposure(0), exposure(1), exposure(2)};
    return kFrames;
}

std::string recording(const std::string& file) {
    {
        RawRecorder recorder(file);
        recorder.start(pages(), TimePoint(50s));
        for (std::size_t i = 0; i < frames().size(); ++i)
            send(recorder, frames()[i], TimePoint(50s + 33ms * (static_cast<int>(i) + 1)));
        recorder.finish();
        EXPECT_EQ(recorder.counters().error, "");
        EXPECT_EQ(recorder.counters().leftOut, 0U);
        // Five pages; of each frame ten sub-images of nine packets and the first empty one.
        EXPECT_EQ(recorder.counters().written, 5U + 3 * 100);
    }
    std::ifstream in(file, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(in), {});
    EXPECT_EQ(bytes.size(), std::filesystem::file_size(file));
    return bytes;
}

/// What is read to the end of a stream.
std::vector<devices::Frame> play(devices::Source& source) {
    std::vector<devices::Frame> all;
    for (;;) {
        auto result = source.read(TimePoint::max());
        auto* frame = std::get_if<devices::Frame>(&result);
        if (frame == nullptr) return all;
        all.push_back(std::move(*frame));
    }
}

TEST(RawRecording, PlaysBackWhatTheCameraGave) {
    const ScratchFolder folder;
    const std::string file = folder / "a.k2raw";
    static_cast<void>(recording(file));
    EXPECT_TRUE(isRawRecording(file));
    devices::Input input = openRawRecording(file, std::nullopt);
    EXPECT_TRUE(input.description.starts_with("raw recording of a Kinect v2 000001234567"))
        << input.description;
    const auto played = play(*input.depth);
    ASSERT_EQ(played.size(), 3U);
    DepthFrames live(std::make_shared<UnitContinuity>(), parseFacts(pages()));
    for (std::size_t i = 0; i < played.size(); ++i) {
        const auto expected = live.convert({frames()[i], TimePoint{}});
        ASSERT_TRUE(expected);
        EXPECT_TRUE(std::ranges::equal(expected->depth(), played[i].depth()));
        EXPECT_TRUE(std::ranges::equal(expected->amplitude(), played[i].amplitude()));
        EXPECT_EQ(played[i].metadata().sequence, i);
        // 33 ms after the start, which is at 100 ms, less half a frame; the clock may creep.
        const auto time = played[i].metadata().capturedAt.time_since_epoch();
        EXPECT_NEAR(static_cast<double>(time.count()) * 1e-6,
                    100 + 33.0 * (static_cast<double>(i) + 1) - 16.667, 0.5);
    }
    EXPECT_TRUE(std::holds_alternative<devices::Ended>(input.depth->read(TimePoint::max())));
    ASSERT_TRUE(input.depth->rewind());
    EXPECT_EQ(play(*input.depth).size(), 3U);
    EXPECT_EQ(input.depth->counters().damaged, 0U);
    EXPECT_EQ(input.depth->counters().delivered, 6U);
}

TEST(RawRecording, ACutFilePlaysToItsLastWholeRecord) {
    const ScratchFolder folder;
    const std::string file = folder / "a.k2raw";
    const std::string whole = recording(file);
    const std::size_t record = sizeof(RawHeader);
    std::size_t pagesEnd = kRawMagic.size();
    for (const std::size_t page :
         {pages().serial.size(), pages().firmware.size(), pages().phases.size(),
          pages().depth.size(), pages().color.size()})
        pagesEnd += record + page;
    const std::size_t frameBytes = (whole.size() - pagesEnd) / 3;
    ASSERT_EQ(pagesEnd + 3 * frameBytes, whole.size());
    std::mt19937 random(3);
    for (int i = 0; i < 24; ++i) {
        const std::size_t size = pagesEnd + random() % (whole.size() - pagesEnd);
        std::filesystem::resize_file(file, size);
        devices::Input input = openRawRecording(file, std::nullopt);
        // A frame is whole with its ninth sub-image: the tenth and what ends it may be missing.
        const std::size_t tenth = devices::kinect2::DepthPackets::kTransferBytes + 10 * record;
        const std::size_t expected =
            std::min<std::size_t>(3, (size - pagesEnd + tenth + record) / frameBytes);
        EXPECT_EQ(play(*input.depth).size(), expected) << size;
        EXPECT_EQ(input.depth->counters().damaged, 0U) << "cut is not damaged";
        std::ofstream(file, std::ios::binary) << whole;
    }
    for (const std::size_t size : {std::size_t{8}, std::size_t{40}, pagesEnd - 1}) {
        std::filesystem::resize_file(file, size);
        EXPECT_THROW(static_cast<void>(openRawRecording(file, std::nullopt)), devices::DeviceError);
        std::ofstream(file, std::ios::binary) << whole;
    }
}

TEST(RawRecording, AKilledRecorderLeavesWhatCanBePlayed) {
    const ScratchFolder folder;
    const std::string file = folder / "a.k2raw";
    std::mt19937 random(5);
    static_cast<void>(frames());
    for (int i = 0; i < 8; ++i) {
        std::filesystem::remove(file);
        const pid_t child = fork();
        if (child == 0) {
            RawRecorder recorder(file);
            recorder.start(pages(), TimePoint(50s));
            for (int frame = 0;; ++frame) {
                send(recorder, frames()[static_cast<std::size_t>(frame % 3)],
                     TimePoint(50s + 33ms * frame));
                std::this_thread::sleep_for(5ms);
            }
        }
        std::error_code none;
        const auto sizeNow = [&] {
            const auto size = std::filesystem::file_size(file, none);
            return none ? 0 : size;
        };
        for (int wait = 0; wait < 2000 && sizeNow() < 6'000'000; ++wait)
            std::this_thread::sleep_for(5ms);
        std::this_thread::sleep_for(std::chrono::milliseconds(random() % 60));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        devices::Input input = openRawRecording(file, std::nullopt);
        const std::size_t played = play(*input.depth).size();
        EXPECT_GE(played, 1U);
        // All that is in the file but a part of a frame.
        EXPECT_GE(played, (sizeNow() - pages().phases.size()) / 3'000'000 - 1);
        EXPECT_EQ(input.depth->counters().damaged, 0U);
    }
}

TEST(RawRecording, OneWrongBitIsSeen) {
    const ScratchFolder folder;
    const std::string file = folder / "a.k2raw";
    const std::string whole = recording(file);
    std::mt19937 random(4);
    for (int i = 0; i < 16; ++i) {
        // Before the last frame's tenth sub-image, which nobody needs.
        const std::size_t at = whole.size() / 2 + random() % (whole.size() * 4 / 10);
        std::string bytes = whole;
        bytes[at] = static_cast<char>(bytes[at] ^ 1 << random() % 8);
        std::ofstream(file, std::ios::binary) << bytes;
        devices::Input input = openRawRecording(file, std::nullopt);
        EXPECT_LT(play(*input.depth).size(), 3U);
        EXPECT_EQ(input.depth->counters().damaged, 1U);
    }
}

TEST(RawRecording, WhatDoesNotFitIsLeftOutAndNoHalvesAreJoined) {
    const ScratchFolder folder;
    const std::string file = folder / "a.k2raw";
    // Room for the pages and a frame and a half, filled faster than any disk.
    RawRecorder recorder(file, std::size_t{6} << 20U);
    recorder.start(pages(), TimePoint(50s));
    for (int i = 0; i < 60; ++i)
        send(recorder, frames()[static_cast<std::size_t>(i % 3)], TimePoint(51s));
    recorder.finish();
    EXPECT_GT(recorder.counters().leftOut, 0U);
    EXPECT_EQ(recorder.counters().error, "");
    RawReader reader(std::make_unique<std::ifstream>(file, std::ios::binary));
    RawRecord record;
    bool marked = false;
    while (reader.next(record))
        marked |= record.header.kind == RawKind::DepthPacket && record.header.intact == 0;
    EXPECT_TRUE(marked) << "what is left out is a loss";
    devices::Input input = openRawRecording(file, std::nullopt);
    DepthFrames live(std::make_shared<UnitContinuity>(), parseFacts(pages()));
    const auto played = play(*input.depth);
    EXPECT_GE(played.size(), 1U);
    for (const devices::Frame& frame : played) {
        const bool known = std::ranges::any_of(frames(), [&](const RawDepthFrame& raw) {
            const auto expected = live.convert({raw, TimePoint{}});
            return expected && std::ranges::equal(expected->depth(), frame.depth());
        });
        EXPECT_TRUE(known);
    }
}

TEST(RawRecording, AFullDiskEndsTheRecordingOnly) {
    EXPECT_THROW(RawRecorder("/nowhere/a.k2raw"), std::runtime_error);
    const ScratchFolder folder;
    std::filesystem::create_symlink("/dev/full", folder / "full");
    try {
        RawRecorder recorder(folder / "full");
        FAIL() << "the name of the format cannot have been written";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("No space left on device"), std::string::npos);
    }
}

/// As long as this lives no file of this program grows beyond so much.
class LargestFile {
  public:
    explicit LargestFile(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
    }
    LargestFile(const LargestFile&) = delete;
    LargestFile& operator=(const LargestFile&) = delete;
    ~LargestFile() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

  private:
    void (*handler_)(int);
    rlimit before_{};
};

TEST(RawRecording, ADiskThatFillsUpLeavesWhatCanBePlayed) {
    const ScratchFolder folder;
    const std::string file = folder / "a.k2raw";
    constexpr rlim_t kRoom = 8U << 20U; // the pages, two frames and a part of one
    std::uint64_t written = 0;
    {
        const LargestFile largest(kRoom);
        RawRecorder recorder(file);
        recorder.start(pages(), TimePoint(50s));
        for (int i = 0; i < 12 && recorder.counters().error.empty(); ++i) {
            send(recorder, frames()[static_cast<std::size_t>(i % 3)], TimePoint(50s + 33ms * i));
            std::this_thread::sleep_for(50ms);
        }
        const auto ended = recorder.counters();
        EXPECT_NE(ended.error.find("cannot record to " + file + ": File too large"),
                  std::string::npos)
            << ended.error;
        // Whoever goes on sending neither waits nor fills memory.
        for (int i = 0; i < 100; ++i)
            send(recorder, frames()[0], TimePoint(51s));
        recorder.finish();
        EXPECT_GE(recorder.counters().leftOut, ended.leftOut + 10'000);
        EXPECT_EQ(recorder.counters().bytes, ended.bytes);
        written = recorder.counters().bytes;
    }
    EXPECT_GE(std::filesystem::file_size(file), written);
    EXPECT_LE(std::filesystem::file_size(file), kRoom);
    devices::Input input = openRawRecording(file, std::nullopt);
    EXPECT_GE(play(*input.depth).size(), 1U);
    EXPECT_EQ(input.depth->counters().damaged, 0U) << "cut is not damaged";
}

TEST(RawRecording, AnotherFileIsNone) {
    const ScratchFolder folder;
    EXPECT_FALSE(isRawRecording(folder / "none"));
    EXPECT_FALSE(isRawRecording(folder.write("text", "ASK2RAW")));
    EXPECT_FALSE(isRawRecording(folder.write("text", "ASK2RAW2 and so on")));
}

} // namespace
} // namespace autostereo::test

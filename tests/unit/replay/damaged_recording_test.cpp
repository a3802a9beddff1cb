#include "devices/input.hpp"
#include "devices/replay/image_files.hpp"
#include "tests/support/data.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/replay/playing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

namespace autostereo {
namespace {

using Clock = std::chrono::steady_clock;

// A case takes some 20 ms in a debug build; the rest is room for sanitizers.
constexpr std::chrono::seconds kLongest{1};
constexpr int kCases = 200;
constexpr unsigned kSeed = 20260101;

struct Outcome {
    int refused = 0; ///< DeviceError while opening
    int frames = 0;
    std::uint64_t damaged = 0;
};

/// Opens and plays to the end. Anything but a DeviceError while opening fails the test.
void playOnce(const std::filesystem::path& path, Outcome& outcome, const std::string& what) try {
    const auto input = devices::openInput(path);
    for (auto* source : {input.depth.get(), input.color.get()}) {
        if (source == nullptr) continue;
        const int frames = test::countFrames(*source);
        EXPECT_LE(frames, 2) << what; // the file has one of each; a flip may make IR depth
        outcome.frames += frames;
        outcome.damaged += source->counters().damaged;
    }
} catch (const devices::DeviceError& error) {
    ++outcome.refused;
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
}

/// The same within the time; a busy machine may hold it up, so a slow case gets a second chance.
void play(const std::filesystem::path& path, Outcome& outcome, const std::string& what) {
    const auto seconds = [&](Outcome& result) {
        const auto begin = Clock::now();
        playOnce(path, result, what);
        return Clock::now() - begin;
    };
    if (seconds(outcome) < kLongest) return;
    Outcome again;
    EXPECT_LT(seconds(again), kLongest) << what;
}

class DamagedRecording : public ::testing::Test {
  protected:
    void SetUp() override {
        AUTOSTEREO_NEED_DATA("k4a-mug/recording.mkv");
        original = devices::readFile(test::dataDir() / "k4a-mug/recording.mkv", 64U << 20U);
        path = folder.write("damaged.mkv",
                            {reinterpret_cast<const char*>(original.data()), original.size()});
        fd = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
        ASSERT_GE(fd, 0);
    }
    void TearDown() override {
        if (fd >= 0) ::close(fd);
    }
    void put(std::size_t at, std::byte value) const {
        ASSERT_EQ(::pwrite(fd, &value, 1, static_cast<off_t>(at)), 1);
    }
    void flip(std::size_t at, std::byte mask, Outcome& outcome) const {
        put(at, original[at] ^ mask);
        play(path, outcome,
             "byte " + std::to_string(at) + " mask " + std::to_string(static_cast<int>(mask)));
        put(at, original[at]);
    }

    test::ScratchFolder folder;
    std::vector<std::byte> original;
    std::filesystem::path path;
    int fd = -1;
};

TEST_F(DamagedRecording, cutAnywhere) {
    std::mt19937 random(kSeed);
    std::vector<std::size_t> sizes;
    sizes.reserve(kCases);
    for (int i = 0; i < kCases; ++i)
        sizes.push_back(random() % original.size());
    std::ranges::sort(sizes, std::greater<>{});
    Outcome outcome;
    for (const std::size_t size : sizes) {
        ASSERT_EQ(::ftruncate(fd, static_cast<off_t>(size)), 0);
        play(path, outcome, "cut to " + std::to_string(size));
    }
    // Colour ends after 13 % of the file, depth after 57 %: cuts behind them keep those frames.
    EXPECT_GT(outcome.frames, kCases);
    EXPECT_GT(outcome.damaged, static_cast<std::uint64_t>(kCases) / 2);
}

TEST_F(DamagedRecording, bytesFlippedAnywhere) {
    std::mt19937 random(kSeed);
    Outcome outcome;
    for (int i = 0; i < kCases; ++i) {
        const std::size_t at = random() % original.size();
        flip(at, static_cast<std::byte>(1 + random() % 255), outcome);
    }
    EXPECT_GT(outcome.frames, kCases); // most flips hit pixels
}

TEST_F(DamagedRecording, bytesFlippedInTheStructure) {
    // Everything but pixels: the first 8 kB, and the heads of the blocks.
    constexpr std::size_t kStructure = 7600;
    std::mt19937 random(kSeed);
    Outcome outcome;
    for (int i = 0; i < kCases; ++i) {
        const std::size_t at = random() % kStructure;
        flip(at, static_cast<std::byte>(1 + random() % 255), outcome);
    }
    for (const std::size_t block : {7546U, 7564U, 224667U, 961955U})
        for (std::size_t at = block; at < block + 12; ++at)
            flip(at, std::byte{0xFF}, outcome);
    EXPECT_GT(outcome.refused, 10);
    EXPECT_GT(outcome.frames, kCases);
}

TEST_F(DamagedRecording, laceCountThatHangsTheLibrary) {
    // Fixed lacing with 256 laces in the depth block: flags 0x04, then 0xFF.
    const std::size_t flags = 224667 + 4 + 3;
    ASSERT_EQ(original[224667], std::byte{0xA3});
    const std::byte before = original[flags];
    put(flags, std::byte{0x04});
    put(flags + 1, std::byte{0xFF});
    Outcome outcome;
    play(path, outcome, "fixed lacing");
    EXPECT_EQ(outcome.frames, 1); // colour
    EXPECT_EQ(outcome.damaged, 1U);
    put(flags, before);
}

} // namespace
} // namespace autostereo

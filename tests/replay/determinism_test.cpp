#include "tests/replay/program.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace autostereo::test {
namespace {

std::string bytesOf(const std::string& file) {
    std::ifstream bytes(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(bytes), {}};
}

struct Outcome {
    std::string snapshot;
    RunReport::Accounts accounts;
};

Outcome play(const std::string& input, const char* frames) {
    const TempFolder folder;
    EXPECT_TRUE(succeeded(
        runProgram(calling({"run", "--input", input, "--display", smallDisplay(folder), "--output",
                            "offscreen", "--speed", "max", "--frames", frames, "--snapshot",
                            folder / "panel.png", "--report", folder / "report.json"}))));
    return {bytesOf(folder / "panel.png"), readReport(folder / "report.json").accounts};
}

void expectTheSameTwice(const std::string& input, const char* frames) {
    const Outcome first = play(input, frames), second = play(input, frames);
    EXPECT_FALSE(first.snapshot.empty());
    EXPECT_EQ(first.snapshot, second.snapshot) << "the panels differ";
    EXPECT_EQ(first.accounts, second.accounts) << "the accounts differ";
    EXPECT_EQ(first.accounts.dropped, 0U);
}

TEST(Determinism, OfASimulationWithNoise) { expectTheSameTwice(kSmallPerson, "8"); }

TEST(Determinism, OfAKinectRecording) {
    AUTOSTEREO_NEED_DATA("k4a-mug/recording.mkv");
    expectTheSameTwice(dataDir() / "k4a-mug/recording.mkv", "8");
}

TEST(Determinism, OfPicturesWithTheirOwnTimes) {
    AUTOSTEREO_NEED_DATA("tum-fr1-rpy");
    expectTheSameTwice("tum:" + (dataDir() / "tum-fr1-rpy").string(), "8");
}

/// Else the tests above would compare nothing with nothing.
TEST(Determinism, AnotherSeedIsAnotherPicture) {
    EXPECT_NE(play(kSmallPerson, "3").snapshot,
              play(std::string(kSmallPerson) + "&seed=2", "3").snapshot);
}

} // namespace
} // namespace autostereo::test

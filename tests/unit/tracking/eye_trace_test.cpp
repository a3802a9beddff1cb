#include "devices/input.hpp"
#include "devices/tracking/eye_trace.hpp"
#include "devices/tracking/open_eyes.hpp"
#include "tests/support/fake_clock.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

namespace autostereo::test {
namespace {

using devices::parseEyeTrace;
using namespace std::chrono_literals;

constexpr const char* kGood = "# seconds, left, right\n"
                              "0, -0.03, 0.01, 0.65, 0.033, 0.02, 0.66\n"
                              "\n"
                              "  0.5 ,-0.02,0,0.7,0.04,0,0.7 # later\r\n"
                              "2,-0.02,0,0.7,0.04,0,0.7";

TEST(EyeTrace, LinesAreSamples) {
    const auto trace = parseEyeTrace(kGood, "t.csv");
    ASSERT_EQ(trace.size(), 3U);
    EXPECT_EQ(trace[0].at, 0ns);
    EXPECT_EQ(trace[0].eyes.left, (glm::dvec3{-0.03, 0.01, 0.65}));
    EXPECT_EQ(trace[0].eyes.right, (glm::dvec3{0.033, 0.02, 0.66}));
    EXPECT_EQ(trace[1].at, 500ms);
    EXPECT_EQ(trace[2].at, 2s);
}

std::string refusal(const std::string& text) {
    try {
        static_cast<void>(parseEyeTrace(text, "t.csv"));
    } catch (const devices::DeviceError& error) {
        return error.what();
    }
    return "read";
}

TEST(EyeTrace, EveryWrongLineIsNamed) {
    const std::string line = "0,-0.03,0,0.65,0.03,0,0.65\n";
    EXPECT_EQ(refusal(""), "t.csv: no sample in it");
    EXPECT_EQ(refusal("# nothing\n\n"), "t.csv: no sample in it");
    const std::string wants = "wants seconds and six coordinates, separated by commas";
    EXPECT_EQ(refusal(line + "1,2,3\n"), "t.csv:2: " + wants);
    EXPECT_EQ(refusal(line + "1,0,0,1,0,0,1,5\n"), "t.csv:2: " + wants);
    EXPECT_EQ(refusal("\n\n1,0,0,x,0,0,1\n"), "t.csv:3: number 4 is none");
    EXPECT_EQ(refusal("nan,0,0,1,0,0,1\n"), "t.csv:1: number 1 is none");
    EXPECT_EQ(refusal("0,inf,0,1,0,0,1\n"), "t.csv:1: number 2 is none");
    EXPECT_EQ(refusal("0,1e999,0,1,0,0,1\n"), "t.csv:1: number 2 is none");
    EXPECT_EQ(refusal("-1,0,0,1,0,0,1\n"), "t.csv:1: seconds out of range (allowed 0 to 1000000)");
    EXPECT_EQ(refusal("1e300,0,0,1,0,0,1\n"),
              "t.csv:1: seconds out of range (allowed 0 to 1000000)");
    EXPECT_EQ(refusal(line + line), "t.csv:2: is not later than the sample before it");
    EXPECT_EQ(refusal("0,0,0,0.05,0,0,1\n"),
              "t.csv:1: no viewer's eyes (allowed 0.1 to 10 m from the panel, 10 m to each side)");
    EXPECT_EQ(refusal(std::string(64, '\0')), "t.csv:1: number 1 is none");
}

TEST(EyeTrace, PlaysOnceByTheClock) {
    const ScratchFolder folder;
    FakeClock clock;
    devices::ViewerParams params;
    params.source = "file:" + folder.write("t.csv", kGood).string();
    const auto start = clock.now();
    const auto source = devices::openEyes(params, {0, 0, 0.65}, start, false, clock);
    ASSERT_TRUE(source->next(start));
    EXPECT_FALSE(source->next(start + 499ms));
    const auto second = source->next(start + 5s);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->at, start + 500ms);
    EXPECT_TRUE(source->next(start + 5s));
    EXPECT_FALSE(source->next(start + 1h));
    EXPECT_EQ(source->counters().accepted, 3U);
}

TEST(EyeTrace, AFileThatIsNotThereIsSaid) {
    FakeClock clock;
    devices::ViewerParams params;
    params.source = "file:/nowhere/t.csv";
    EXPECT_THROW(
        static_cast<void>(devices::openEyes(params, {0, 0, 0.65}, clock.now(), false, clock)),
        devices::DeviceError);
}

} // namespace
} // namespace autostereo::test

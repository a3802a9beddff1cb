#include "tests/replay/program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace autostereo::test {
namespace {

TEST(LatencyCommand, AKnownDelayIsFoundOnARunningPanel) {
    const TempFolder folder;
    const ProgramResult result = runProgram(calling(
        {"latency", "--display", smallDisplay(folder), "--camera",
         "sim:panel?delay_ms=37&exposure_ms=6&transfer_ms=9&fps=27", "--seconds", "5", "--json"}));
    ASSERT_TRUE(succeeded(result));
    const auto found = nlohmann::json::parse(result.out);
    // Swaps and exposures are stamped on one clock, so a busy machine costs readings, no accuracy.
    EXPECT_LE(found.at("delay_between_ms").at(0), 37.0);
    EXPECT_GE(found.at("delay_between_ms").at(1), 37.0);
    const double within = found.at("each_within_ms");
    EXPECT_GE(found.at("swap_to_light_ms").at("p50"), 37 - within);
    EXPECT_LE(found.at("swap_to_light_ms").at("p99"), 37 + within);
    // And half the exposure, and the transfer; more where the machine is busy.
    EXPECT_GE(found.at("swap_to_arrival_ms").at("p50"), 37 - within + 3 + 9);
    EXPECT_GT(found.at("readings"), 30);
}

TEST(LatencyCommand, SaysWhatItCannotDo) {
    const TempFolder folder;
    EXPECT_TRUE(failedPlainly(runProgram(calling({"latency", "--camera", "sim:room"})), 2));
    EXPECT_TRUE(
        failedPlainly(runProgram(calling({"latency", "--camera", "sim:panel?delay=20"})), 2));
    EXPECT_TRUE(failedPlainly(runProgram(calling({"latency", "--seconds", "0"})), 2));
    EXPECT_TRUE(
        failedPlainly(runProgram(calling({"latency", "--camera", "v4l2:/dev/no-such-camera"})), 3));
    // A median of two pictures is none.
    const ProgramResult few =
        runProgram(calling({"latency", "--display", smallDisplay(folder), "--camera",
                            "sim:panel?fps=1", "--seconds", "2"}));
    EXPECT_TRUE(failedPlainly(few, 1));
}

} // namespace
} // namespace autostereo::test

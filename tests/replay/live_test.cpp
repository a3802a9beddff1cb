#include "tests/replay/program.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>

namespace autostereo::test {
namespace {

RunReport live(const std::string& display, const std::string& input, std::chrono::seconds length) {
    const TempFolder folder;
    auto call = calling({"run", "--input", input, "--display",
                         display.empty() ? smallDisplay(folder) : display, "--output", "offscreen",
                         "--frames", "1000000", "--report", folder / "report.json"});
    call.limit += length;
    call.interruption = {SIGTERM, length};
    EXPECT_TRUE(succeeded(runProgram(call)));
    return readReport(folder / "report.json");
}

/// The picture that is shown is at most two turns of the loop old: one that was drawn while its
/// frame arrived, one of its own. A queue that lags grows old with the length of the run.
void expectDropsNotLag(const RunReport& report) {
    ASSERT_GT(report.accounts.presented, 0U);
    ASSERT_TRUE(report.latencyP50Ms && report.latencyP99Ms);
    const double turnMs = 1000 * report.seconds / static_cast<double>(report.accounts.presented);
    EXPECT_GT(*report.latencyP50Ms, 0);
    EXPECT_LT(*report.latencyP50Ms, std::max(500.0, 2.5 * turnMs));
    EXPECT_LE(*report.latencyP50Ms, *report.latencyP99Ms);
    EXPECT_TRUE(balanced(report));
}

TEST(Live, AccountsBalanceAndPicturesAreFresh) {
    const std::chrono::seconds length(fullCampaign() ? 60 : 5);
    const RunReport report = live("", kSmallPerson, length);
    expectDropsNotLag(report);
    EXPECT_NEAR(report.seconds, static_cast<double>(length.count()), 2.0 * kSlower);
    // 30 frames a second, less the start and what a busy machine's cameras are late.
    EXPECT_GT(report.accounts.depth.in, static_cast<std::uint64_t>(10 * length.count() / kSlower));
}

TEST(Live, ADisplayTooHeavyDropsFrames) {
    // Simulated cameras cannot keep 60 a second under a sanitizer, and never make a pair then.
    const std::string rate = kSlower > 1 ? "&fps=15" : "&fps=60";
    const RunReport report = live("looking-glass-portrait", kSmallPerson + rate,
                                  std::chrono::seconds((fullCampaign() ? 60 : 8) * kSlower));
    expectDropsNotLag(report);
    const RunReport::Accounts& all = report.accounts;
    if (report.renderer.starts_with("llvmpipe")) {
        EXPECT_GT(all.dropped + all.depth.unpaired, all.presented);
    }
}

} // namespace
} // namespace autostereo::test

// Real threads, a panel off-screen that takes pictures at 60 Hz: what a picture's way is made of.
#include "daemon/session/percentiles.hpp"
#include "tests/replay/program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

namespace autostereo::test {
namespace {

using namespace std::chrono_literals;
using Milliseconds = std::chrono::duration<double, std::milli>;

constexpr double kRefreshMs = 1000.0 / 60, kPeriodMs = 1000.0 / 30;

/// How late this machine wakes a thread, as long as it lives: what others' work costs us.
class Hiccups {
  public:
    [[nodiscard]] daemon::Percentiles end() {
        thread_ = {};
        return lateMs_;
    }

  private:
    daemon::Percentiles lateMs_;
    std::jthread thread_{[this](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            const auto due = std::chrono::steady_clock::now() + 2ms;
            std::this_thread::sleep_until(due);
            lateMs_.add(Milliseconds(std::chrono::steady_clock::now() - due).count());
        }
    }};
};

struct PacedRun {
    nlohmann::json report;
    double hiccupMs = 0; ///< 99th percentile
    [[nodiscard]] double part(const char* name, const char* which) const {
        return report.at("latency_parts_ms").at(name).at(which);
    }
};

PacedRun runPaced() {
    const TempFolder folder;
    const std::string config =
        folder.file("paced.toml", "[output]\nkind = \"offscreen\"\nrefresh_hz = 60\n");
    Hiccups hiccups;
    const ProgramCall call =
        calling({"run", "--config", config, "--input", kSmallPerson, "--display",
                 smallDisplay(folder), "--frames", "100", "--report", folder / "report.json"});
    EXPECT_TRUE(succeeded(runProgram(call)));
    std::ifstream text(folder / "report.json");
    return {nlohmann::json::parse(text), hiccups.end().at(0.99).value()};
}

/// Beside what it measures itself (transfer, the later camera, drawing), a picture waits for a
/// nearer colour frame, half a period at most, and for the picture before it; but however long that
/// takes, no longer than until a newer pair is there, a period; then for one refresh.
bool keepsToItsParts(const PacedRun& run) {
    const double before = run.part("draw", "max") + kRefreshMs;
    const double wait = kPeriodMs / 2 + std::min(before, kPeriodMs) + run.hiccupMs;
    const double swap = kRefreshMs + run.hiccupMs;
    const double all = run.part("transfer", "max") + run.part("pairing", "max") + wait +
                       run.part("draw", "max") + swap;
    const double p99 = run.report.at("latency_ms").at("p99");
    std::printf("p99 %.1f ms of %.1f: transfer %.1f, pairing %.1f, wait %.1f of %.1f, draw %.1f, "
                "swap %.1f of %.1f; this machine wakes up %.1f ms late\n",
                p99, all, run.part("transfer", "p99"), run.part("pairing", "p99"),
                run.part("wait", "p99"), wait, run.part("draw", "p99"), run.part("swap", "p99"),
                swap, run.hiccupMs);
    return run.part("wait", "p99") <= wait && run.part("swap", "p99") <= swap && p99 <= all;
}

TEST(Latency, IsWhatItsPartsTakeAndNoMore) {
    constexpr int kTurns = 3; // others' work may spoil some
    bool kept = false, busy = true;
    for (int turn = 0; turn < kTurns && !kept; ++turn) {
        const PacedRun run = runPaced();
        ASSERT_GT(run.report.at("frames_presented"), 0);
        kept = keepsToItsParts(run);
        busy &= run.hiccupMs > kPeriodMs / 2;
        // Pictures leave at the ticks of the panel's clock: waiting for one takes half a refresh
        // on average, and is never skipped.
        EXPECT_GT(run.part("swap", "max"), kRefreshMs / 4);
    }
    if (!kept && busy) GTEST_SKIP() << "threads wake up more than half a period late here and now";
    EXPECT_TRUE(kept);
}

} // namespace
} // namespace autostereo::test

// Faults one after the other, seeded, on the whole program but its command line: after each the
// picture is right again within two seconds, nothing old was called live, nothing is kept, and a
// counter tells what happened.

#include "tests/stress/campaign.hpp"
#include "tests/stress/session/fault_kinds.hpp"
#include "tests/stress/session/level.hpp"
#include "tests/support/gl_fixture.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

namespace autostereo::test {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kLimit{2000};
constexpr const char* kRoom = "sim:room?depth=64x48&color=64x36&noise=off";
constexpr const char* kPerson = "sim:person?depth=64x48&color=64x36";
constexpr std::size_t kPictures = 30; // one second
/// Rings of times that fill (0.3 MiB), allocators that move by some pages.
constexpr double kMostGrowthMib = 2;

/// A line of the report.
struct Outcome {
    std::vector<long long> recoveryMs;
    std::uint64_t counted = 0, wrong = 0;
    double oldestMs = 0;
    std::string counter;
};

class FaultCampaign : public testing::Test {
  protected:
    void SetUp() override {
        try {
            const gpu::gl::SurfacelessContext context(false);
        } catch (const gpu::GlError& error) {
            if (required("gl")) FAIL() << error.what();
            GTEST_SKIP() << error.what();
        }
    }
    void round(const Rehearsal::Scene& scene, const std::vector<FaultKind>& kinds, Random& random);
    void meet(Rehearsal& rehearsal, const FaultKind& kind, Random& random);
    void write() const;

    ScratchFolder folder;
    std::map<std::string, Outcome> outcomes;
    std::uint64_t faults = 0;
};

/// What is left when pictures are right again; threads and connections end a moment later.
void expectLevel(Rehearsal& rehearsal, const Level& before) {
    constexpr int kTries = 50;
    Level now = levelNow();
    const auto same = [&] {
        return now.descriptors <= before.descriptors && now.threads <= before.threads &&
               now.gpu.objects <= before.gpu.objects && now.gpu.bytes <= before.gpu.bytes;
    };
    for (int i = 0; i < kTries && !same(); ++i) {
        rehearsal.runFor(milliseconds(20));
        now = levelNow();
    }
    EXPECT_LE(now.descriptors, before.descriptors);
    EXPECT_LE(now.threads, before.threads);
    EXPECT_LE(now.gpu.objects, before.gpu.objects);
    EXPECT_LE(now.gpu.bytes, before.gpu.bytes);
}

void expectBalanced(Rehearsal& rehearsal) {
    const daemon::Report& report = rehearsal.session().accounts();
    for (const devices::StreamCounters* stream : {&report.feed.depth, &report.feed.color}) {
        EXPECT_EQ(stream->in, stream->paired + stream->unpaired);
        EXPECT_EQ(stream->paired, report.feed.pairs);
    }
    EXPECT_EQ(report.feed.pairs, report.presented + report.skippedTotal() + report.feed.dropped);
}

void FaultCampaign::meet(Rehearsal& rehearsal, const FaultKind& kind, Random& random) {
    rehearsal.forget();
    const std::uint64_t before = kind.count(rehearsal);
    kind.happen(rehearsal, random);
    const auto recovery = rehearsal.untilRight(kLimit);
    EXPECT_TRUE(recovery) << "not right again within two seconds, shows "
                          << rehearsal.session().status().shown;
    const std::uint64_t counted = kind.count(rehearsal) - before;
    EXPECT_GT(counted, 0U) << kind.counter;
    EXPECT_LE(rehearsal.seen().overdueMs, 0) << "called live";
    expectBalanced(rehearsal);
    Outcome& outcome = outcomes[kind.name];
    outcome.counter = kind.counter;
    outcome.counted += counted;
    outcome.wrong += rehearsal.seen().wrong;
    outcome.oldestMs = std::max(outcome.oldestMs, rehearsal.seen().oldestMs);
    outcome.recoveryMs.push_back(recovery.value_or(kLimit).count());
    ++faults;
}

void FaultCampaign::round(const Rehearsal::Scene& scene, const std::vector<FaultKind>& kinds,
                          Random& random) {
    Rehearsal rehearsal(folder, scene);
    const Level level = levelNow();
    for (const FaultKind& kind : kinds) {
        SCOPED_TRACE("fault " + std::to_string(faults) + ": " + kind.name + ", " + scene.input);
        meet(rehearsal, kind, random);
        expectLevel(rehearsal, level);
    }
}

/// Beside the test's program, for people and for machines.
void FaultCampaign::write() const {
    const auto build = std::filesystem::canonical("/proc/self/exe").parent_path();
    std::ostringstream table;
    table << "| fault | times | right again: median, longest (ms) | counter | wrong pictures | "
             "oldest live (ms) |\n|---|---|---|---|---|---|\n";
    nlohmann::ordered_json rows;
    for (const auto& [name, outcome] : outcomes) {
        std::vector<long long> times = outcome.recoveryMs;
        std::ranges::sort(times);
        const long long median = times[times.size() / 2], longest = times.back();
        table << "| " << name << " | " << times.size() << " | " << median << ", " << longest
              << " | " << outcome.counter << ": " << outcome.counted << " | " << outcome.wrong
              << " | " << std::lround(outcome.oldestMs) << " |\n";
        rows.push_back({{"fault", name},
                        {"recovery_ms", times},
                        {"counter", outcome.counter},
                        {"counted", outcome.counted},
                        {"wrong_pictures", outcome.wrong},
                        {"oldest_live_ms", outcome.oldestMs}});
    }
    std::cout << table.str() << faults << " faults of " << outcomes.size() << " kinds\n";
    std::ofstream(build / "fault_campaign.md") << table.str();
    std::ofstream(build / "fault_campaign.json") << rows.dump(1) << '\n';
}

/// The scene's first second as a recording in the folder.
std::string recordingOf(const std::string& scene, const ScratchFolder& folder) {
    daemon::RunOptions options;
    options.scene.input = scene;
    options.output = config::Output::Offscreen;
    options.frames = kPictures;
    options.speed = config::Speed::Max;
    options.record = folder / "replay.mkv";
    daemon::Session session(options, daemon::configuration(options.scene));
    while (session.step()) {
    }
    static_cast<void>(session.close());
    return *options.record;
}

TEST_F(FaultCampaign, ThePictureIsRightAgainWithinTwoSeconds) {
    if (IsSkipped()) return;
    const std::uint64_t rounds = campaign(3, 10), shares = campaign(4, 1);
    const Rehearsal::Scene scenes[] = {{kPerson, kPictures, "written.mkv"},
                                       {recordingOf(kPerson, folder), kPictures, "written.mkv"},
                                       {kRoom, 1, "written.mkv"}};
    Random random(1);
    std::vector<FaultKind> kinds = faultKinds();
    std::ranges::shuffle(kinds, random);
    double settledMib = 0;
    for (std::uint64_t i = 0; i < rounds && !HasFailure(); ++i) {
        const auto first = static_cast<std::ptrdiff_t>(kinds.size() * (i % shares) / shares);
        const auto last = static_cast<std::ptrdiff_t>(kinds.size() * (i % shares + 1) / shares);
        std::vector<FaultKind> share(kinds.begin() + first, kinds.begin() + last);
        std::ranges::shuffle(share, random);
        round(scenes[i % std::size(scenes)], share, random);
        const double residentMib = levelNow().residentMib;
        std::cout << "round " << i << ": " << residentMib << " MiB\n";
        // By then every scene and every kind has been met: drivers keep compiled shaders.
        if (i == 2) settledMib = residentMib;
        if (i > 2) {
            EXPECT_LE(residentMib, settledMib + kMostGrowthMib);
        }
    }
    write();
}

} // namespace
} // namespace autostereo::test

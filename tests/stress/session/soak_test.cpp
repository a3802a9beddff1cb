// As fast as it goes, with something wrong every now and then, the configuration read again and
// again: the process does not grow, accounts balance, and in the end the picture is the right one.

#include "gpu/gl/context.hpp"
#include "gpu/gl/error.hpp"
#include "tests/stress/campaign.hpp"
#include "tests/stress/session/level.hpp"
#include "tests/stress/session/rehearsal.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <random>

namespace autostereo::test {
namespace {

using std::chrono::milliseconds;

/// All but those that take real time to come back from.
constexpr std::array kFaults{
    SensorFault::Unplugged, SensorFault::Silent,  SensorFault::Burst,   SensorFault::OtherSize,
    SensorFault::Zero,      SensorFault::Garbage, SensorFault::Damaged, SensorFault::OtherFormat,
    SensorFault::Back,      SensorFault::Forward, SensorFault::Extreme, SensorFault::Saturated,
    SensorFault::Stuck,     SensorFault::Jitter,  SensorFault::Drift,   SensorFault::Numbered,
    SensorFault::Repeated,  SensorFault::Twice,   SensorFault::Flood};

constexpr std::uint64_t kLap = 250; // pictures, of which a fault takes a part

class Soak {
  public:
    explicit Soak(const ScratchFolder& folder)
        : rehearsal_(folder, {"sim:person?depth=16x16&color=16x16", 8, "", milliseconds(1)}) {}

    [[nodiscard]] std::uint64_t pictures() { return rehearsal_.session().accounts().presented; }
    /// Some hundred pictures with one fault among them, every tenth time another configuration.
    void lap() {
        const std::uint64_t end = pictures() + kLap;
        for (const SensorFault fault : {nextFault(), SensorFault::None}) {
            const milliseconds amount(1 + random_() % 500);
            if (random_() % 3 != 0 || fault == SensorFault::None)
                rehearsal_.depth().give(fault, amount);
            if (random_() % 3 != 0 || fault == SensorFault::None)
                rehearsal_.color().give(fault, amount);
            const auto until = std::chrono::steady_clock::now() + milliseconds(30);
            while (std::chrono::steady_clock::now() < until)
                rehearsal_.pass();
        }
        if (++laps_ % 10 == 0) reload();
        const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(10);
        while (pictures() < end && std::chrono::steady_clock::now() < limit)
            for (int i = 0; i < 50; ++i)
                rehearsal_.pass();
        ASSERT_GE(pictures(), end)
            << "no pictures any more, shows " << rehearsal_.session().status().shown;
    }
    void expectBalanced() {
        const daemon::Report& report = rehearsal_.session().accounts();
        for (const devices::StreamCounters* stream : {&report.feed.depth, &report.feed.color}) {
            ASSERT_EQ(stream->in, stream->paired + stream->unpaired);
            ASSERT_EQ(stream->paired, report.feed.pairs);
        }
        ASSERT_EQ(report.feed.pairs,
                  report.presented + report.skippedTotal() + report.feed.dropped);
    }
    /// What is kept for a while after a fault (connections, a camera's other textures) has gone.
    [[nodiscard]] Level settled() {
        rehearsal_.runFor(milliseconds(200));
        return levelNow();
    }
    [[nodiscard]] Rehearsal& rehearsal() { return rehearsal_; }

  private:
    /// Each once, then any.
    [[nodiscard]] SensorFault nextFault() {
        return kFaults[laps_ < kFaults.size() ? laps_ : random_() % kFaults.size()];
    }
    void reload() {
        const bool wrong = laps_ % 30 == 0;
        rehearsal_.configure(wrong ? "nonsense = 1\n" : "picture.brightness = 0.5\n");
        rehearsal_.ask(daemon::ReloadRequest{});
        rehearsal_.configure();
        rehearsal_.ask(daemon::ReloadRequest{});
    }

    Rehearsal rehearsal_;
    std::mt19937 random_{7};
    std::uint64_t laps_ = 0;
};

void print(const Level& level, std::uint64_t pictures, double seconds) {
    std::cout << pictures << " pictures, " << static_cast<double>(pictures) / seconds
              << "/s: " << level.residentMib << " MiB, " << level.descriptors << " descriptors, "
              << level.threads << " threads, " << level.gpu.objects << " GL objects, "
              << level.gpu.bytes << " bytes" << std::endl;
}

TEST(Soak, NothingGrowsAndNothingDrifts) {
    ::setenv("LP_NUM_THREADS", "0", 1); // so small a panel is drawn faster by one
    try {
        const gpu::gl::SurfacelessContext context(false);
    } catch (const gpu::GlError& error) {
        if (required("gl")) FAIL() << error.what();
        GTEST_SKIP() << error.what();
    }
    const std::uint64_t pictures = campaign(3000, 1'000'000);
    // Rings of times are full, every fault was met; allocators settle later.
    const std::uint64_t warmUp = campaign(5500, 50'000);
    const ScratchFolder folder;
    Soak soak(folder);
    const auto started = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    };
    while (soak.pictures() < warmUp)
        ASSERT_NO_FATAL_FAILURE(soak.lap());
    const Level warm = soak.settled();
    print(warm, soak.pictures(), seconds());
    for (std::uint64_t next = 0; soak.pictures() < warmUp + pictures;) {
        ASSERT_NO_FATAL_FAILURE(soak.lap());
        ASSERT_NO_FATAL_FAILURE(soak.expectBalanced());
        if (soak.pictures() < next) continue;
        next = soak.pictures() + pictures / 20;
        const Level now = soak.settled();
        print(now, soak.pictures(), seconds());
        EXPECT_LT(now.residentMib, warm.residentMib + 1);
        EXPECT_LE(now.descriptors, warm.descriptors);
        EXPECT_LE(now.threads, warm.threads);
        EXPECT_LE(now.gpu.objects, warm.gpu.objects);
        EXPECT_LE(now.gpu.bytes, warm.gpu.bytes);
    }
    EXPECT_TRUE(soak.rehearsal().untilRight(milliseconds(2000)));
}

} // namespace
} // namespace autostereo::test

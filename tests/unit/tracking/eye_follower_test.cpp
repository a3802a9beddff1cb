#include "devices/tracking/eye_follower.hpp"
#include "tests/unit/tracking/eye_times.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace autostereo::test {
namespace {

using calib::EyePair;
using devices::EyeFollower;
using devices::ViewerParams;

constexpr glm::dvec3 kHalf{0.0315, 0, 0};

EyePair around(const glm::dvec3& middle) { return {middle - kHalf, middle + kHalf}; }

const EyePair kNominal = around({0, 0, 0.65});
const EyePair kAside = around({0.2, 0.1, 0.8});

/// Samples of somebody who stands still, every 10 ms from `from` to `to` seconds.
void stand(EyeFollower& follower, const EyePair& eyes, double from, double to) {
    for (double at = from; at < to - 1e-6; at += 0.01)
        follower.add({atSeconds(at), eyes});
}

double away(const EyePair& a, const EyePair& b) {
    return std::max(glm::length(a.left - b.left), glm::length(a.right - b.right));
}

TEST(EyeFollower, WithoutSamplesTheEyesAreTheNominalOnes) {
    const EyeFollower follower({}, kNominal);
    EXPECT_EQ(away(follower.eyes(atSeconds(5)), kNominal), 0);
    EXPECT_FALSE(follower.isTracked(atSeconds(5)));
}

TEST(EyeFollower, FoundAndLostEyesEaseWithinHalfASecond) {
    const ViewerParams params;
    EyeFollower follower(params, kNominal);
    stand(follower, kAside, 0, 2);
    EXPECT_LT(away(follower.eyes(atSeconds(1.99)), kAside), 1e-9);
    EXPECT_TRUE(follower.isTracked(atSeconds(2.1)));

    // The last sample was at 1.99: lost 0.2 s later, nominal 0.5 s after that, half way in between.
    EXPECT_LT(away(follower.eyes(atSeconds(2.189)), kAside), 1e-9);
    EXPECT_FALSE(follower.isTracked(atSeconds(2.191)));
    EXPECT_NEAR(away(follower.eyes(atSeconds(2.44)), kAside), away(kNominal, kAside) / 2, 1e-6);
    EXPECT_GT(away(follower.eyes(atSeconds(2.68)), kNominal), 0);
    EXPECT_LT(away(follower.eyes(atSeconds(2.69 + 1e-6)), kNominal), 1e-9);
    EXPECT_LT(away(follower.eyes(atSeconds(9)), kNominal), 1e-9);
}

TEST(EyeFollower, NeverJumpsWhateverIsLostWhen) {
    const ViewerParams params;
    EyeFollower follower(params, kNominal);
    EyePair before = kNominal;
    double fastest = 0;
    for (int i = 0; i < 6000; ++i) { // milliseconds
        const double at = 0.001 * i;
        // Gaps of every length, some shorter than the loss, some in the middle of an ease.
        const bool seen = (i / 100) % 7 > 2 && (i / 350) % 5 != 1;
        if (seen && i % 10 == 0) follower.add({atSeconds(at), kAside});
        const EyePair now = follower.eyes(atSeconds(at));
        fastest = std::max(fastest, away(now, before) / 0.001);
        before = now;
    }
    // Half a second with a smooth step is at its fastest 1.5 times the mean speed.
    EXPECT_LT(fastest, 1.5 * away(kNominal, kAside) / 0.5 + 1e-3);
    EXPECT_GT(fastest, 0.5 * away(kNominal, kAside) / 0.5);
}

TEST(EyeFollower, WalkersAreMetWhereTheyWillBe) {
    ViewerParams params;
    params.delay = std::chrono::milliseconds(30);
    EyeFollower follower(params, kNominal);
    const auto walker = [](double at) { return around({-0.5 + 0.5 * at, 0, 0.65}); };
    for (int i = 0; i <= 200; ++i)
        follower.add({atSeconds(0.01 * i), walker(0.01 * i)});
    // Asked 7 ms after the last sample, for light that leaves 30 ms later.
    EXPECT_LT(away(follower.eyes(atSeconds(2.007)), walker(2.037)), 4e-4); // restSpeed, see OneEuro
}

TEST(EyeFollower, AWalkerWhoIsLostIsNotCarriedOnForEver) {
    EyeFollower follower({}, kNominal);
    for (int i = 0; i <= 100; ++i)
        follower.add({atSeconds(0.01 * i), around({3.0 * 0.01 * i, 0, 0.65})});
    double farthest = 0;
    for (int i = 0; i < 2000; ++i)
        farthest = std::max(farthest, follower.eyes(atSeconds(1 + 0.001 * i)).left.x);
    EXPECT_LT(farthest, 3.0 + 3.0 * 0.24); // 200 ms until it counts as lost, and the delay
    EXPECT_LT(away(follower.eyes(atSeconds(3)), kNominal), 1e-9);
}

TEST(EyeFollower, DisorderIsCountedAndWildSpeedsStayInFront) {
    EyeFollower follower({}, kNominal);
    follower.add({atSeconds(1), kAside});
    follower.add({atSeconds(1), kNominal});
    follower.add({atSeconds(0.5), kNominal});
    EXPECT_EQ(follower.disordered(), 2U);
    // Ten metres in a nanosecond.
    follower.add({atSeconds(1.000000001), around({-9, 9, 0.2})});
    follower.add({atSeconds(1.000000002), around({9, -9, 9})});
    for (int i = 0; i < 100; ++i)
        EXPECT_TRUE(devices::isPlausible(follower.eyes(atSeconds(1.01 * (1 + 0.01 * i)))));
}

} // namespace
} // namespace autostereo::test

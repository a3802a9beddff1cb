// Two cameras that follow a waved board, their clocks apart.

#include "calib/solve/refusal.hpp"
#include "calib/solve/time_offset.hpp"
#include "tests/unit/calibrate/simulated_boards.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace autostereo::calibrate {
namespace {

/// Waved by hand: half a second to and fro, 15 cm wide, not quite regular.
glm::dvec3 wavedBoard(double time) {
    return {0.15 * std::sin(6.0 * time) + 0.03 * std::sin(17 * time + 1),
            0.08 * std::cos(4.7 * time), 1.2 + 0.05 * std::sin(3.1 * time)};
}

/// Three seconds at 30 pictures a second, one in ten without the board; jitter of the stamps.
std::vector<TimedPlace> seenBy(SimulatedBoards& simulated, double firstS, double lateS,
                               double speed, const glm::dvec3& shift) {
    std::vector<TimedPlace> places;
    for (int i = 0; i < 90; ++i) {
        const double time = firstS + i / 30.0 + simulated.gaussian(2e-4);
        if (simulated.between(0, 1) < 0.1) continue;
        const glm::dvec3 noise{simulated.gaussian(2e-4), simulated.gaussian(2e-4),
                               simulated.gaussian(1e-3)};
        places.push_back({time + lateS, wavedBoard(speed * time) + shift + noise});
    }
    return places;
}

TEST(TimeOffset, LiesInItsInterval) {
    int held = 0;
    double worst = 0;
    constexpr int kRuns = 200;
    for (std::uint32_t seed = 1; seed <= kRuns; ++seed) {
        SimulatedBoards simulated(seed);
        const double lateS = simulated.between(-0.08, 0.08);
        const glm::dvec3 shift{0.004, -0.003, 0.010}; // a rig that is off
        const auto depth = seenBy(simulated, 0, 0, 1, glm::dvec3(0));
        const auto color = seenBy(simulated, simulated.between(-0.03, 0.03), lateS, 1, shift);
        const TimeOffset found = timeOffset(depth, color);
        const double off = std::fabs(found.colorLateS - lateS);
        worst = std::fmax(worst, off);
        held += off <= found.late95S ? 1 : 0;
        EXPECT_NEAR(found.shift.x, -shift.x, 2e-3);
    }
    std::printf("worst of %d: %.2f ms, in the interval in %.1f %%\n", kRuns, 1e3 * worst,
                100.0 * held / kRuns);
    EXPECT_LT(worst, 1e-3);
    EXPECT_GE(held, 0.90 * kRuns);
    EXPECT_LE(held, 0.99 * kRuns);
}

std::string refusalOf(double speed, std::size_t pictures) {
    SimulatedBoards simulated(1);
    auto depth = seenBy(simulated, 0, 0, speed, glm::dvec3(0));
    const auto color = seenBy(simulated, 0, 0.01, speed, glm::dvec3(0));
    depth.resize(std::min(depth.size(), pictures));
    try {
        static_cast<void>(timeOffset(depth, color));
        return "taken";
    } catch (const Refusal& refusal) {
        return refusal.what();
    }
}

TEST(TimeOffset, RefusesWhatCannotTell) {
    EXPECT_EQ(refusalOf(1, 90), "taken");
    EXPECT_NE(refusalOf(0, 90).find("moved too little"), std::string::npos) << refusalOf(0, 90);
    EXPECT_NE(refusalOf(0.003, 90).find("moved too little"), std::string::npos)
        << refusalOf(0.003, 90);
    EXPECT_NE(refusalOf(1, 12).find("too few pictures"), std::string::npos);
    EXPECT_NE(refusalOf(1, 0).find("too few pictures"), std::string::npos);
}

} // namespace
} // namespace autostereo::calibrate

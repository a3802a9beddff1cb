// 200 simulated rigs: are the stated intervals true?

#include "tests/unit/calibrate/simulated_boards.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <map>

namespace autostereo::calibrate {
namespace {

/// How often a true number lay in its 95 % interval.
struct Tally {
    int inside = 0, all = 0;
    void add(double found, double truth, double half95) {
        inside += std::fabs(found - truth) <= half95 ? 1 : 0;
        ++all;
    }
    [[nodiscard]] double share() const { return static_cast<double>(inside) / all; }
};

void addCamera(std::map<std::string, Tally>& tallies, const std::string& which,
               const CameraCalibration& found, const calib::CameraModel& truth) {
    constexpr std::array kNames{"fx", "fy", "cx", "cy"};
    const CameraParameters is = parametersOf(found.camera), was = parametersOf(truth);
    for (std::size_t i = 0; i < kNames.size(); ++i)
        tallies[which + kNames.at(i)].add(is.at(i), was.at(i), found.half95.at(i));
}

// The truth has five terms, so a model with fewer would state intervals that are too narrow. 200
// runs of a 95 % interval: binomial standard error 1.5 %, so 90 to 99 % is -3.2 to +2.6 of them.
TEST(SimulatedRigs, TheTruthLiesInTheStatedIntervals) {
    std::map<std::string, Tally> tallies;
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        SimulatedBoards simulated(seed);
        const calib::SensorRig truth = simulated.rig();
        const double noise = simulated.between(0.05, 0.4);
        const int count = static_cast<int>(simulated.between(10, 16));
        const auto seen = simulated.views(truth, kSimulatedBoard, count, noise, 0.7, 1.6, 0.6);
        const RigCalibration found = calibrateRig(kSimulatedBoard, seen.views, kSimulatedSizes);
        addCamera(tallies, "depth ", found.depth, truth.depth);
        addCamera(tallies, "colour ", found.color, truth.color);
        const calib::RigidTransform off = found.colorFromDepth * truth.colorFromDepth.inverse();
        const glm::dquat turn = glm::quat_cast(off.rotation);
        for (glm::length_t i = 0; i < 3; ++i) {
            tallies["turn " + std::to_string(i)].add(2 * glm::dvec3(turn.x, turn.y, turn.z)[i], 0,
                                                     found.turn95Rad[i]);
            tallies["shift " + std::to_string(i)].add(found.colorFromDepth.translation[i],
                                                      truth.colorFromDepth.translation[i],
                                                      found.shift95M[i]);
        }
    }
    for (const auto& [name, tally] : tallies) {
        std::printf("%-10s %5.1f %%\n", name.c_str(), 100 * tally.share());
        EXPECT_GE(tally.share(), 0.90) << name;
        EXPECT_LE(tally.share(), 0.99) << name;
    }
}

} // namespace
} // namespace autostereo::calibrate

// Views that cannot support a calibration are refused, with the reason.

#include "calib/solve/refusal.hpp"
#include "tests/unit/calibrate/simulated_boards.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace autostereo::calibrate {
namespace {

constexpr std::uint32_t kSeeds = 10;

/// Why the depth camera's views of that rig are refused; empty where they are not.
std::string reasonFor(std::uint32_t seed, int count, double nearM, double farM, double tilt) {
    SimulatedBoards simulated(seed);
    const calib::SensorRig rig = simulated.rig();
    const auto seen = simulated.views(rig, kSimulatedBoard, count, 0.2, nearM, farM, tilt);
    try {
        static_cast<void>(calibrateCamera(kSimulatedBoard, seen.views.depth, 640, 576));
        return "";
    } catch (const Refusal& refusal) {
        return refusal.what();
    }
}

void expectReason(const std::string& reason, std::initializer_list<const char*> words,
                  std::uint32_t seed) {
    EXPECT_TRUE(std::ranges::any_of(
        words, [&](const char* word) { return reason.find(word) != std::string::npos; }))
        << "seed " << seed << ": " << (reason.empty() ? "not refused" : reason);
}

TEST(Refusals, GoodViewsAreTaken) {
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed)
        EXPECT_EQ(reasonFor(seed, 12, 0.7, 1.6, 0.6), "") << seed;
}

TEST(Refusals, FewViews) {
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed)
        expectReason(reasonFor(seed, 4, 0.7, 1.6, 0.6), {"4 views of the board"}, seed);
}

TEST(Refusals, ParallelBoards) {
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed)
        expectReason(reasonFor(seed, 12, 0.7, 1.6, 0.02),
                     {"nearly parallel", "no focal length", "focal length is known to"}, seed);
}

TEST(Refusals, FarBoards) {
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed)
        expectReason(reasonFor(seed, 12, 5.5, 7.0, 0.6), {"too far away"}, seed);
}

TEST(Refusals, ViewsOfAnotherBoardAreDroppedByName) {
    SimulatedBoards simulated(3);
    const calib::SensorRig rig = simulated.rig();
    auto seen = simulated.views(rig, kSimulatedBoard, 12, 0.2, 0.7, 1.6, 0.6);
    BoardView& bent = seen.views.depth[4];
    for (std::size_t i = 0; i < bent.size(); ++i) // a corner taken for its neighbour
        if (bent.ids[i] % 9 > 5) bent.pixels[i].x += 4;
    const auto found = calibrateCamera(kSimulatedBoard, seen.views.depth, 640, 576);
    std::vector<std::string> rejected;
    for (const ViewScore& view : found.views)
        if (view.rejected) rejected.push_back(view.name);
    EXPECT_EQ(rejected, std::vector<std::string>{bent.name});
    EXPECT_LT(found.rmsPx, 0.35) << "0.2 px in each direction";
}

} // namespace
} // namespace autostereo::calibrate

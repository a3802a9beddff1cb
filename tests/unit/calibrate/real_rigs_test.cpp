// Two real cameras and the board that both photographed: what OpenCV's own calibration says of
// them, and the trap that a missing term of the distortion is. Squares count as metres, their size
// is not known.

#include "calib/solve/rig_solver.hpp"
#include "tests/unit/calibrate/real_boards.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace autostereo::calibrate {
namespace {

constexpr PictureSizes kVga{640, 480, 640, 480};

/// Pairs whose number is the same.
RigViews paired(std::vector<BoardView> depth, std::vector<BoardView> color,
                const std::vector<std::string>& depthFiles,
                const std::vector<std::string>& colorFiles) {
    RigViews views{std::move(depth), std::move(color), {}};
    for (std::size_t d = 0; d < views.depth.size(); ++d)
        for (std::size_t c = 0; c < views.color.size(); ++c)
            for (std::size_t i = 0; i < depthFiles.size(); ++i)
                if (views.depth[d].name == depthFiles[i] && views.color[c].name == colorFiles[i])
                    views.pairs.emplace_back(d, c);
    return views;
}

void print(const char* name, const RigCalibration& found) {
    std::printf("%s: rms %.3f px with cameras as found alone, %.3f px together; f %.1f +- %.1f and "
                "%.1f +- %.1f; t %.4f %.4f %.4f +- %.4f %.4f %.4f\n",
                name, found.separateRmsPx, found.jointRmsPx, found.depth.camera.intrinsics.fx,
                found.depth.half95[0], found.color.camera.intrinsics.fx, found.color.half95[0],
                found.colorFromDepth.translation.x, found.colorFromDepth.translation.y,
                found.colorFromDepth.translation.z, found.shift95M.x, found.shift95M.y,
                found.shift95M.z);
    for (const ModelTrial& trial : found.depth.trials)
        std::printf("  %-22s rms %.3f, left out %.3f, f %.1f +- %.1f, condition %.0e\n",
                    nameOf(trial.lens).data(), trial.rmsPx, trial.heldOutPx, trial.focalPx,
                    trial.focal95Px, trial.condition);
    for (const std::string& warning : found.depth.warnings)
        std::printf("  %s\n", warning.c_str());
    for (const ViewScore& pair : found.pairs)
        std::printf("  %s %.2f%s\n", pair.name.c_str(), pair.rmsPx,
                    pair.rejected ? " rejected" : "");
}

// OpenCV's own sample: 0.276 px, 3.31 squares apart.
TEST(RealRigs, ReachOpenCvsSample) {
    AUTOSTEREO_NEED_DATA("stereo-chess/left01.jpg");
    const auto left = stereoFiles("left"), right = stereoFiles("right");
    RigViews views =
        paired(boardsIn(left, kStereoBoard), boardsIn(right, kStereoBoard), left, right);
    const RigCalibration found = calibrateRig(kStereoBoard, views, kVga);
    print("stereo", found);
    EXPECT_EQ(views.pairs.size(), 13U) << "every board is wholly in both pictures";
    EXPECT_LE(found.depth.rmsPx, 0.26);
    EXPECT_LE(found.color.rmsPx, 0.26);
    EXPECT_LE(found.jointRmsPx, 0.28);
    EXPECT_NEAR(glm::length(found.colorFromDepth.translation), 3.33, 0.03);

    // A board that moved between the two pictures: the right one is of another moment.
    std::swap(views.pairs[2].second, views.pairs[5].second);
    const RigCalibration without = calibrateRig(kStereoBoard, views, kVga);
    print("two pairs swapped", without);
    EXPECT_EQ(std::ranges::count(without.pairs, true, &ViewScore::rejected), 2);
    EXPECT_NEAR(glm::length(without.colorFromDepth.translation), 3.33, 0.03);
}

// 0.37 px with each camera's numbers as found alone, 0.23 px when refined together (measured with
// OpenCV); k3 = 0 leaves 0.97.
TEST(RealRigs, RefineTogetherWhatFewViewsLeaveOpen) {
    AUTOSTEREO_NEED_DATA("tof-chess/1_ir.png");
    const auto infrared = tofFiles("_ir.png"), color = tofFiles("_color.jpg");
    const RigViews views =
        paired(boardsIn(infrared, kTofBoard), boardsIn(color, kTofBoard), infrared, color);
    ASSERT_EQ(views.pairs.size(), 7U);
    const RigCalibration found = calibrateRig(kTofBoard, views, kVga);
    print("time of flight", found);
    EXPECT_EQ(found.depth.lens, LensModel::Five);
    EXPECT_NEAR(found.depth.camera.intrinsics.fx, 465, 8);
    EXPECT_LE(found.jointRmsPx, 0.30);
    EXPECT_LT(found.jointRmsPx, found.separateRmsPx - 0.05);
    EXPECT_TRUE(std::ranges::any_of(found.depth.warnings, [](const std::string& warning) {
        return warning.starts_with("k1 k2 p1 p2 (k3 = 0)") && warning.ends_with(" px)");
    })) << "k3 = 0 fits to 0.23 px, with a focal length of 516";
}

} // namespace
} // namespace autostereo::calibrate

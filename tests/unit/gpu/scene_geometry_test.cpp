#include "devices/frame_pool.hpp"
#include "gpu/scene_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace autostereo::gpu {
namespace {

constexpr int kWidth = 30, kHeight = 21;
constexpr double kMillimetre = 0.001;

calib::SensorRig plainRig() {
    calib::SensorRig rig;
    rig.depth = {{kWidth, kHeight, 30, 30, (kWidth - 1) / 2.0, (kHeight - 1) / 2.0}, {}};
    rig.color = rig.depth;
    return rig;
}

/// Median depth of a picture made of counts.
std::optional<double> medianOf(const std::function<int(int x, int y)>& count,
                               const calib::SensorRig& rig = plainRig(),
                               const DepthMeshParams& mesh = {}, double unitM = kMillimetre,
                               int width = kWidth, int height = kHeight) {
    devices::FramePool pool(1);
    devices::FrameMetadata form;
    form.format = devices::PixelFormat::Depth16;
    form.width = width;
    form.height = height;
    form.depthUnitM = unitM;
    auto frame = pool.acquire(form);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            frame->depth()[static_cast<std::size_t>(y * width + x)] =
                static_cast<std::uint16_t>(count(x, y));
    return medianDepth(*frame, rig, mesh);
}

bool central(int x, int y) {
    return x >= kWidth / 3 && x < 2 * kWidth / 3 && y >= kHeight / 3 && y < 2 * kHeight / 3;
}

TEST(CountRange, IsInclusiveAtEveryMillimetre) {
    for (const double unitM : {0.001, 0.0005, 0.0002, 0.000125})
        for (int mm = 1; mm < 8000; ++mm) {
            const CountRange range = countRange({mm * 1e-3, mm * 1e-3, 0.05}, unitM);
            const auto count = static_cast<std::uint32_t>(std::lround(mm * 1e-3 / unitM));
            ASSERT_EQ(range.nearest, count) << mm << " mm in units of " << unitM;
            ASSERT_EQ(range.farthest, count) << mm << " mm in units of " << unitM;
        }
}

TEST(CountRange, BetweenCountsRoundsInwards) {
    const CountRange range = countRange({0.1504, 2.0006, 0.05}, kMillimetre);
    EXPECT_EQ(range.nearest, 151U);
    EXPECT_EQ(range.farthest, 2000U);
}

TEST(CountRange, NeverTakesTheCountsThatMeanNothing) {
    const CountRange all = countRange({0, 1000, 0.05}, kMillimetre);
    EXPECT_EQ(all.nearest, 1U);
    EXPECT_EQ(all.farthest, 65534U);
    const CountRange endless =
        countRange({0, std::numeric_limits<double>::infinity(), 0.05}, kMillimetre);
    EXPECT_EQ(endless.farthest, 65534U);
    const CountRange beyond = countRange({100, 200, 0.05}, kMillimetre);
    EXPECT_EQ(beyond.nearest, 65534U);
    EXPECT_EQ(beyond.farthest, 65534U);
    const CountRange crossed = countRange({2, 1, 0.05}, kMillimetre);
    EXPECT_GE(crossed.farthest, crossed.nearest);
}

TEST(MedianDepth, LeavesOutWhatIsBehindTheColorCamera) {
    calib::SensorRig rig = plainRig();
    rig.colorFromDepth.translation.z = -1; // the colour camera stands a metre farther forward
    EXPECT_FALSE(medianOf([](int, int) { return 900; }, rig));
    EXPECT_NEAR(*medianOf([](int x, int y) { return (x + y) % 2 == 0 ? 900 : 1500; }, rig), 0.5,
                1e-9);
}

TEST(MedianDepth, IsTheMiddleOfTheCentralThird) {
    // 70 pixels there: 40 at 1.2 m, the rest at 3 m; everything around is at 0.5 m.
    const auto median = medianOf([](int x, int y) {
        if (!central(x, y)) return 500;
        return (y - kHeight / 3) * (kWidth / 3) + x - kWidth / 3 < 40 ? 1200 : 3000;
    });
    EXPECT_DOUBLE_EQ(median.value(), 1.2);
}

TEST(MedianDepth, LooksAtTheCentralThirdAndNowhereElse) {
    const auto median = medianOf([](int x, int y) {
        return central(x, y) && x == kWidth / 3 && y == kHeight / 3 ? 2000
               : central(x, y)                                      ? 0
                                                                    : 700;
    });
    EXPECT_DOUBLE_EQ(median.value(), 2.0);
    const auto lastCorner = medianOf([](int x, int y) {
        return x == 2 * kWidth / 3 - 1 && y == 2 * kHeight / 3 - 1 ? 2500
               : central(x, y)                                     ? 65535
                                                                   : 700;
    });
    EXPECT_DOUBLE_EQ(lastCorner.value(), 2.5);
}

TEST(MedianDepth, FallsBackToTheWholePicture) {
    EXPECT_DOUBLE_EQ(medianOf([](int x, int y) { return central(x, y) ? 0 : 700; }).value(), 0.7);
    EXPECT_DOUBLE_EQ(medianOf([](int x, int y) { return x + y == 0 ? 900 : 65535; }).value(), 0.9);
}

TEST(MedianDepth, IsNoneWhereNothingIsMeasured) {
    EXPECT_FALSE(medianOf([](int, int) { return 0; }));
    EXPECT_FALSE(medianOf([](int, int) { return 65535; }));
    EXPECT_FALSE(medianOf([](int, int) { return 149; })); // nearer than 0.15 m
    EXPECT_TRUE(medianOf([](int, int) { return 150; }));
    EXPECT_TRUE(medianOf([](int, int) { return 10000; }));
}

TEST(MedianDepth, CountsInTheFramesUnit) {
    const auto median = medianOf([](int, int) { return 5000; }, plainRig(), {}, 0.0002);
    EXPECT_DOUBLE_EQ(median.value(), 1.0);
}

TEST(MedianDepth, IsSeenFromTheColourCamera) {
    calib::SensorRig rig = plainRig();
    rig.colorFromDepth.translation = {0.3, -0.2, 0.25};
    EXPECT_DOUBLE_EQ(medianOf([](int, int) { return 1000; }, rig).value(), 1.25);
}

TEST(MedianDepth, TakesFramesOfAnotherSizeThanTheCalibration) {
    calib::SensorRig rig = plainRig();
    const double angle = 0.3; // the depth camera looks down: rows differ in colour depth
    rig.colorFromDepth.rotation = {
        1, 0, 0, 0, std::cos(angle), std::sin(angle), 0, -std::sin(angle), std::cos(angle)};
    const auto flat = [](int, int) { return 2000; };
    const double full = medianOf(flat, rig).value();
    const double tripled = medianOf(flat, rig, {}, kMillimetre, 3 * kWidth, 3 * kHeight).value();
    EXPECT_NEAR(tripled, full, 1e-3);
    EXPECT_NEAR(full, 2 * std::cos(angle), 0.02); // a row is worth 2 sin(angle) / 30
}

TEST(SceneGeometry, FillsThePanelWithTheCamerasWidthAtTheFocus) {
    const calib::SensorRig rig = plainRig();
    calib::DisplayProfile display;
    display.widthM = 0.5;
    display.viewingDistanceM = 0.8;
    display.coneRad = 0.6;
    display.disparityFar = -0.05;
    display.disparityNear = 0.02;
    const double focus = 1.5;
    PipelineParams params;
    const SceneGeometry geometry = sceneGeometry(rig, display, params, 16.0 / 9, focus);
    // 29 pixels between the outermost centres, at f = 30, less twice the larger disparity.
    const double shown = 29.0 / 30 / 1.1;
    EXPECT_NEAR(geometry.framing.width, shown, 1e-12);
    EXPECT_NEAR(geometry.framing.height, shown * 9 / 16, 1e-12);
    EXPECT_NEAR(geometry.law.scale, 0.5 / (shown * focus), 1e-12);
    EXPECT_EQ(geometry.law.focusM, focus);
    EXPECT_EQ(geometry.law.viewerDistanceM, 0.8);
    EXPECT_EQ(geometry.law.farthest, -0.05);
    EXPECT_EQ(geometry.law.nearest, 0.02);

    params.budget.depthScale = 2;
    const SceneGeometry doubled = sceneGeometry(rig, display, params, 16.0 / 9, focus);
    EXPECT_DOUBLE_EQ(doubled.law.scale, 2 * geometry.law.scale);
    EXPECT_EQ(doubled.framing.width, geometry.framing.width);
}

} // namespace
} // namespace autostereo::gpu

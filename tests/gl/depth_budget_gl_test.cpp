// The scene's depths are measured as they are, and the picture follows them: at once with the first
// frame, then slowly, and not at all while little changes.

#include "devices/frame_pool.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"

#include <cmath>

using namespace std::chrono_literals;

namespace autostereo::test {
namespace {

class DepthBudgetGlTest : public GlTest {
  protected:
    static constexpr int kWidth = 60, kHeight = 45;

    DepthBudgetGlTest() {
        params.condition.hold = params.condition.flyingPixels = false;
        params.budget.follow = true;
        params.budget.motion = {1, 0.1};
        // Both cameras in one place: what is so far from one is so far from the other.
        rig.colorFromDepth = {};
    }

    /// Another 100 ms of a wall, and of a visitor in front of it who fills the panel's middle.
    void show(int wall, std::optional<int> visitor = {}) {
        frame.depth = *pool.acquire({devices::PixelFormat::Depth16, kWidth, kHeight});
        frame.color = *pool.acquire({devices::PixelFormat::Rgba8, 64, 48});
        const auto counts = frame.depth.depth();
        for (int i = 0; i < kWidth * kHeight; ++i) {
            const bool inside = std::abs(i % kWidth - kWidth / 2) < kWidth / 6;
            counts[static_cast<std::size_t>(i)] =
                static_cast<std::uint16_t>(visitor && inside ? *visitor : wall);
        }
        std::ranges::fill(frame.color.pixels(), std::byte{90});
        frame.depth.metadata().capturedAt = devices::TimePoint(100ms * frames++);
        if (!pipeline) pipeline.emplace(params, rig, display, 96, 128);
        pipeline->prepare(frame);
    }
    [[nodiscard]] double focus() const { return pipeline->geometry().law.focusM; }
    [[nodiscard]] double scale() const { return gpu::relativeScale(pipeline->geometry(), display); }

    gpu::PipelineParams params;
    calib::DisplayProfile display = smallLensDisplay(2, 1, 48, 64);
    calib::SensorRig rig = devices::sim::simulatedRig(kWidth, kHeight, 64, 48);
    devices::FramePool pool{4};
    devices::RgbdFrame frame;
    int frames = 0;
    std::optional<gpu::Pipeline> pipeline;
};

constexpr double kBin = 0.012; ///< of a depth: a bin of the histogram

TEST_F(DepthBudgetGlTest, TheFirstFrameIsRightAtOnceAndStands) {
    if (IsSkipped()) return;
    show(3000, 1200);
    EXPECT_NEAR(focus(), 1.2, 1.2 * kBin);
    EXPECT_NEAR(scale(), params.budget.limits.leastScale, 1e-12) << "the wall is far behind";
    const double first = focus();
    for (int i = 0; i < 10; ++i) {
        show(3000 + 40 * (i % 2), 1200 + 20 * (i % 3));
        EXPECT_EQ(focus(), first);
    }
}

TEST_F(DepthBudgetGlTest, WaitsForTheFirstMeasurement) {
    if (IsSkipped()) return;
    show(0);
    show(65535);
    EXPECT_EQ(focus(), 1);
    show(2000);
    EXPECT_NEAR(focus(), 2, 2 * kBin);
    EXPECT_EQ(scale(), 1) << "a flat scene may have its natural depth";
}

TEST_F(DepthBudgetGlTest, FollowsAVisitorTwoFramesLaterWithItsTimeConstant) {
    if (IsSkipped()) return;
    for (int i = 0; i < 5; ++i)
        show(3000);
    const double before = focus();
    show(3000, 1000);
    show(3000, 1000);
    show(3000, 1000);
    EXPECT_EQ(focus(), before) << "the depths arrive later";
    show(3000, 1000);
    EXPECT_LT(focus(), before);
    EXPECT_NEAR(std::log(focus() / before) / std::log(1.0 / 3), 1 - std::exp(-0.1), 0.01);
    for (int i = 0; i < 60; ++i)
        show(3000, 1000);
    EXPECT_NEAR(focus(), 1, 0.03);
    const double after = focus();
    for (int i = 0; i < 4; ++i)
        show(0);
    EXPECT_EQ(focus(), after) << "a scene that is gone moves nothing";
}

constexpr std::uint64_t kAtRest = 1000; // frames: this is about the budget alone

/// A picture that does not change need not be drawn again, but for what it set in motion.
TEST_F(DepthBudgetGlTest, KnowsWhenNothingMoves) {
    if (IsSkipped()) return;
    show(3000);
    EXPECT_TRUE(pipeline->isStill(kAtRest));
    show(3000, 1000);
    EXPECT_FALSE(pipeline->isStill(kAtRest));
    int drawn = 0;
    for (; !pipeline->isStill(kAtRest) && drawn < 1000; ++drawn)
        show(3000, 1000);
    EXPECT_NEAR(focus(), 1, 0.03);
    EXPECT_GT(drawn, 20);
    EXPECT_LT(drawn, 100);
}

TEST_F(DepthBudgetGlTest, LimitsAndFixedNumbersHold) {
    if (IsSkipped()) return;
    params.budget.limits = {1.5, 2, 0.7, 0.9};
    show(3000, 1000);
    EXPECT_EQ(focus(), 1.5);
    EXPECT_DOUBLE_EQ(scale(), 0.7);
    for (int i = 0; i < 50; ++i)
        show(6000);
    EXPECT_NEAR(focus(), 2, 0.02);

    params.budget.focusM = 0.8;
    params.budget.depthScale = 0.3;
    pipeline.reset();
    show(3000, 1000);
    EXPECT_EQ(focus(), 0.8);
    EXPECT_NEAR(scale(), 0.3, 1e-12);
}

TEST_F(DepthBudgetGlTest, WithoutItThingsStandStill) {
    if (IsSkipped()) return;
    params.budget.follow = false;
    show(2000);
    for (int i = 0; i < 10; ++i)
        show(3000, 1000);
    EXPECT_EQ(focus(), 2);
    EXPECT_EQ(scale(), 1);
    EXPECT_FALSE(pipeline->budget());
}

TEST_F(DepthBudgetGlTest, SaysWhatIsClamped) {
    if (IsSkipped()) return;
    for (int i = 0; i < 4; ++i)
        show(3000, 1200);
    const double columns = pipeline->geometry().framing.width * rig.depth.intrinsics.fx;
    constexpr double kVisitor = 19, kColumn = 1.5; // columns; those at the panel's edges
    EXPECT_NEAR(pipeline->budget()->clampedShare(), 1 - kVisitor / columns, kColumn / columns);
    for (int i = 0; i < 4; ++i)
        show(1200, 1200);
    EXPECT_EQ(pipeline->budget()->clampedShare(), 0);
}

/// Against the mesh in double precision, on the scene that is rendered.
TEST_F(DepthBudgetGlTest, StatisticsAreThoseOfTheMesh) {
    if (IsSkipped()) return;
    const CapturedPair pair = simulate("sim:person?depth=176x144&color=320x180");
    gpu::Pipeline gpuStages({}, pair.rig, display, 96, 128);
    gpuStages.prepare(pair.frame);
    gpu::DepthStatistics statistics;
    EXPECT_FALSE(statistics.takeNewest());
    for (int i = 0; i < 2; ++i) {
        statistics.measure(gpuStages.mesh().layer().points);
        EXPECT_FALSE(statistics.take());
    }
    statistics.measure(gpuStages.mesh().layer().points);
    const auto measured = statistics.take();
    ASSERT_TRUE(measured);

    std::vector<double> panel, centre;
    for (const auto& node : oracle::meshLayer(oracleInput(pair, gpuStages, {})).nodes) {
        if (!node || node->u < 0 || node->u > 1 || node->v < 0 || node->v > 1) continue;
        panel.push_back(node->z);
        if (std::abs(node->u - 0.5) <= 1.0 / 6 && std::abs(node->v - 0.5) <= 1.0 / 6)
            centre.push_back(node->z);
    }
    ASSERT_GT(centre.size(), 500U);
    const auto expectSame = [](const calib::DepthHistogram& histogram, std::vector<double> depths) {
        // Float against double at the panel's border.
        EXPECT_NEAR(static_cast<double>(histogram.total()), static_cast<double>(depths.size()), 5);
        std::ranges::sort(depths);
        for (const double share : {0.05, 0.3, 0.5, 0.95}) {
            const auto last = static_cast<double>(depths.size() - 1);
            const double exact = depths[static_cast<std::size_t>(share * last)];
            EXPECT_NEAR(histogram.quantile(share).value() / exact, 1, kBin) << share;
        }
    };
    expectSame(measured->panel, panel);
    expectSame(measured->centre, centre);
}

} // namespace
} // namespace autostereo::test

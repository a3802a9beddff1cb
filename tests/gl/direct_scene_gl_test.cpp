// Scenes of triangles, every sub-pixel by itself from a few reference viewpoints: against the same
// in double precision.

#include "calib/panel_map.hpp"
#include "tests/support/hybrid_scene_fixture.hpp"

#include <cmath>

namespace autostereo::test {
namespace {

using DirectSceneGlTest = HybridSceneGlTest;

/// Every sub-pixel from its own phase, in double precision: half a level of rounding, and float's
/// share of a place times the steepest change of colour. Where a millionth of a texel decides which
/// piece of surface is met, either may be.
TEST_F(DirectSceneGlTest, DirectSubPixelsShowWhatTheirOwnEyesSee) {
    if (IsSkipped()) return;
    for (const bool poles : {false, true}) {
        if (poles) showPoles();
        const gpu::RgbImage panel = panelBy(gpu::Method::Direct);
        const oracle::References in = readReferences(*pipeline);
        const auto map =
            std::get<calib::ViewMap>(calib::panelMap(display, display.width, display.height));
        int compared = 0, lit = 0, across = 0, different = 0;
        double worst = 0;
        for (int y = 3; y < display.height; y += 17)
            for (int x = 0; x < display.width; ++x)
                for (int channel = 0; channel < 3; ++channel) {
                    const double phase = map.phase(x, y, channel) / 4294967296.0;
                    const double b = map.reversed ? 1 - 2 * phase : 2 * phase - 1;
                    const double u = (x + 0.5 + (channel - 1) / 3.0) / display.width;
                    const double v = (display.height - 0.5 - y) / display.height;
                    const int row = static_cast<int>(v * in.height);
                    const double texel = u * in.tileWidth();
                    const oracle::HybridRoot root = oracle::rootOf(in, row, texel, b);
                    const oracle::HybridSurface surface =
                        root.hit.isWall ? oracle::acrossWall(in, root, row, texel, b)
                                        : oracle::surfaceAt(in, root.reference, row, root.hit.x);
                    const double wanted = oracle::colorOf(surface, look, form(), u, v, b)[channel];
                    const auto at = static_cast<std::size_t>(3 * (y * display.width + x) + channel);
                    const double off = std::abs(panel.pixels[at] - wanted);
                    ++compared;
                    lit += surface.cover > 0 ? 1 : 0;
                    across += root.hit.isWall ? 1 : 0;
                    if (off > 0.6)
                        ++different;
                    else
                        worst = std::max(worst, off);
                }
        std::printf("%d sub-pixels, %d lit, %d across gaps, %d decided otherwise, worst %.3f\n",
                    compared, lit, across, different, worst);
        EXPECT_GT(lit, compared / 6);
        EXPECT_LE(different, compared / 2000);
        EXPECT_GT(across, poles ? 500 : 0);
    }
}

/// Tiles without anything are left out before black; before what is all but black none is.
TEST_F(DirectSceneGlTest, DirectLeavesOutOnlyWhatShowsNothing) {
    if (IsSkipped()) return;
    const gpu::RgbImage some = panelBy(gpu::Method::Direct);
    params.clearColor = {1e-9, 1e-9, 1e-9};
    EXPECT_TRUE(some.pixels == panelBy(gpu::Method::Direct).pixels);
    params.clearColor = {0, 0, 1};
    EXPECT_EQ(panelBy(gpu::Method::Direct).pixels[2], 255);
}

/// Each view's highlight among the sub-pixels that show that view, within half a texel of a tile,
/// as where views are drawn.
TEST_F(DirectSceneGlTest, HighlightsMoveWithTheEye) {
    if (IsSkipped()) return;
    showHighlight();
    params.synthesis.positions = gpu::ViewPositions::OfViews;
    const gpu::RgbImage panel = panelBy(gpu::Method::Direct);
    const auto map =
        std::get<calib::ViewMap>(calib::panelMap(display, display.width, display.height));
    std::vector<double> sums(static_cast<std::size_t>(display.views)), weighted(sums.size());
    for (int y = 0; y < display.height; ++y)
        for (int x = 0; x < display.width; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                const auto at = static_cast<std::size_t>(3 * (y * display.width + x) + channel);
                const double place = (x + 0.5 + (channel - 1) / 3.0) / display.width - 0.5;
                const auto view = static_cast<std::size_t>(map.view(map.phase(x, y, channel)));
                sums[view] += panel.pixels[at];
                weighted[view] += panel.pixels[at] * place * display.widthM;
            }
    double worst = 0;
    for (int view = 0; view < display.views; ++view) {
        const auto at = static_cast<std::size_t>(view);
        ASSERT_GT(sums[at], 0);
        worst = std::max(worst, std::abs(weighted[at] / sums[at] - mirroredAt(positionOf(view))));
    }
    std::printf("worst %.3f texels\n", worst / display.widthM * 96);
    EXPECT_LE(worst, 0.5 * display.widthM / 96);
}

} // namespace
} // namespace autostereo::test

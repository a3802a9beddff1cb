// Views look past the panel's edges by as much as the display's disparity budget: the framing
// leaves so much of both cameras' pictures beyond them that no view has to make up its borders.

#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"

#include <cstdlib>
#include <random>

namespace autostereo::test {
namespace {

constexpr double kFocusM = 1.2;

class OverscanGlTest : public GlTest, public testing::WithParamInterface<double> {
  protected:
    /// A wall at so many metres in a colour of its own at each pixel.
    static void showNoisyWall(CapturedPair& pair, double metres) {
        std::mt19937 random(1);
        for (std::byte& level : pair.frame.color.pixels())
            level = static_cast<std::byte>(random() & 0xffU);
        for (std::uint16_t& count : pair.frame.depth.depth())
            count = static_cast<std::uint16_t>(metres * 1000);
    }
};

/// The most that any row of a column differs from the next column inwards.
int contrastToNext(const gpu::RgbImage& tile, int column, int inwards) {
    int most = 0;
    for (int y = 0; y < tile.height; ++y)
        for (int c = 0; c < 3; ++c) {
            const auto level = [&](int x) {
                const auto at =
                    3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(tile.width) +
                         static_cast<std::size_t>(x)) +
                    static_cast<std::size_t>(c);
                return static_cast<int>(tile.pixels[at]);
            };
            most = std::max(most, std::abs(level(column) - level(column + inwards)));
        }
    return most;
}

TEST_P(OverscanGlTest, OutermostViewsHaveNoRepeatedBorder) {
    if (IsSkipped()) return;
    CapturedPair pair = simulate("sim:room?depth=176x144&color=640x360&noise=off");
    showNoisyWall(pair, GetParam());
    calib::DisplayProfile display = smallLensDisplay(2, 1, 96, 128);
    display.fan = calib::Fan::Edges; // b = -1 and b = 1
    gpu::PipelineParams params;
    params.budget.focusM = kFocusM;
    params.synthesis.method = gpu::Method::Instanced;
    gpu::Pipeline pipeline(params, pair.rig, display, display.width, display.height);
    pipeline.prepare(pair.frame);
    const double d = pipeline.geometry().law.disparity(GetParam());
    ASSERT_GT(std::abs(d), 0.03) << "nothing lies beyond the edges";
    const gpu::RgbImage views = gpu::readFramebuffer(pipeline.atlas()->framebuffer(), 192, 128);
    for (const int view : {0, 1}) {
        const gpu::RgbImage tile = gpu::crop(views, 96 * view, 0, 96, 128);
        for (int column = 0; column < 8; ++column)
            for (const int inwards : {1, -1})
                // Noise, filtered over several pixels of the picture: neighbours within the
                // tile differ by some 100 levels in some row, made-up ones by a few.
                EXPECT_GT(contrastToNext(tile, inwards > 0 ? column : 95 - column, inwards), 40)
                    << "view " << view << ", column " << column << " from the "
                    << (inwards > 0 ? "left" : "right");
    }
}

INSTANTIATE_TEST_SUITE_P(Walls, OverscanGlTest, testing::Values(0.65, 0.9, 2.5, 20.0));

} // namespace
} // namespace autostereo::test

// The algorithms that came before the Combiner (Kooima 2007, section 2.3) on a part of a real
// barrier: against the line screen in extended precision, and against the Combiner.

#include "calib/band_map.hpp"
#include "gpu/scene/line_screen_views.hpp"
#include "tests/oracle/barrier_oracle.hpp"
#include "tests/support/barrier_part.hpp"
#include "tests/support/scene_fixture.hpp"

#include <cmath>
#include <cstdio>

namespace autostereo::test {
namespace {

using gpu::LineScreenMethod;
using oracle::Sharing;

class LineScreenGlTest : public SceneGlTest {
  protected:
    void SetUp() override {
        display = barrierPart(320, 200);
        SceneGlTest::SetUp();
        look.share = 2.5; // to the panel's edges and beyond
    }
    [[nodiscard]] std::array<glm::dvec3, 2> eyes() const {
        const std::vector<glm::dvec3> nominal = calib::nominalEyes(display);
        return {nominal.at(0), nominal.at(1)};
    }
    [[nodiscard]] calib::LineScreen& screen() { return std::get<calib::LineScreen>(display.law); }
    [[nodiscard]] double pixelsPerLine() {
        const calib::LineScreen& s = screen();
        return display.width / (display.widthM * s.linesPerM * std::cos(s.angleRad));
    }

    gpu::RgbImage panelBy(LineScreenMethod method) {
        const gpu::gl::Texture color(GL_RGBA8, display.width, display.height);
        const gpu::gl::Texture depth(GL_DEPTH_COMPONENT32F, display.width, display.height);
        const gpu::gl::Framebuffer target = gpu::gl::makeFramebuffer(color, &depth);
        const gpu::ScenePipeline& placed = draw(look);
        const double aspect = static_cast<double>(display.width) / display.height;
        gpu::LineScreenViews views(display, look.shading, method, {eyes()[0], eyes()[1]});
        views.render(placed.model(), gpu::sceneBlock(look, placed.placement(), display, aspect),
                     target.name());
        return gpu::readFramebuffer(target.name(), display.width, display.height);
    }
    gpu::RgbImage combined() {
        params.synthesis.filter = gpu::TileFilter::Nearest; // a tile has the panel's size
        return SceneGlTest::panelBy(gpu::Method::Multipass);
    }
    /// What the panel should show, by the line screen in extended precision.
    gpu::RgbImage exact(Sharing sharing) {
        gpu::ScenePipeline& drawn = draw(look);
        return oracle::interleaved(display, eyes(),
                                   {drawn.renderEye(eyes()[0], display.width, display.height),
                                    drawn.renderEye(eyes()[1], display.width, display.height)},
                                   sharing);
    }
    /// Share of sub-pixels that differ by more than a level.
    static double different(const gpu::RgbImage& a, const gpu::RgbImage& b) {
        double count = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i)
            if (std::abs(a.pixels[i] - b.pixels[i]) > 1) ++count;
        return count / static_cast<double>(a.pixels.size());
    }
    /// The rasteriser knows corners to 1/256 pixel, so that an edge may lie 1/512 pixel off: so
    /// much of each line's width, for two edges and two eyes. Half as much again, as places are
    /// few.
    double rounding() { return 1.5 * 4 / 512.0 / pixelsPerLine(); }
};

TEST_F(LineScreenGlTest, ThreePassesAColorAreTheCombinersPicture) {
    if (IsSkipped()) return;
    const gpu::RgbImage direct = panelBy(LineScreenMethod::ThreeThree), combiner = combined();
    std::printf("3/3 to the Combiner: %.4f %% of sub-pixels, to exact lines %.4f %%\n",
                100 * different(direct, combiner),
                100 * different(direct, exact(Sharing::Subpixels)));
    EXPECT_LT(different(direct, combiner), rounding());
    EXPECT_LT(different(direct, exact(Sharing::Subpixels)), rounding());
    EXPECT_GT(different(combiner, exact(Sharing::Pixels)), 0.05); // a picture that tells
}

/// Whole pixels: their middles are right, and the outer thirds of a pixel are wrong where an edge
/// of a band goes through between: a third of a pixel at each, for red and for blue.
TEST_F(LineScreenGlTest, OnePassIsRightForWholePixels) {
    if (IsSkipped()) return;
    scene = emptyScene(); // all white
    scene.materials[0] = {.name = "white", .diffuse = glm::vec3(1)};
    addBall(scene, {0, 0, 0}, 1, 10, 0);
    look.shading = gpu::SceneShading::None;
    const gpu::RgbImage whole = panelBy(LineScreenMethod::OneOne);
    EXPECT_LT(different(whole, exact(Sharing::Pixels)), rounding());
    const double errant = different(whole, panelBy(LineScreenMethod::ThreeThree));
    const double expected = 4.0 / pixelsPerLine() * (1.0 / 3 + 1.0 / 3) / 3;
    std::printf("1/1: %.2f %% of sub-pixels are errant, %.2f %% expected\n", 100 * errant,
                100 * expected);
    EXPECT_NEAR(errant, expected, 0.02 * expected); // some 10,000 of them
}

TEST_F(LineScreenGlTest, FourScreensAndOneSceneAreThePictureOfThree) {
    if (IsSkipped()) return;
    const gpu::RgbImage three = panelBy(LineScreenMethod::ThreeThree);
    const gpu::RgbImage four = panelBy(LineScreenMethod::FourOne);
    std::printf("4/1 to 3/3: %.4f %% of sub-pixels\n", 100 * different(four, three));
    EXPECT_LT(different(four, three), rounding());
}

/// Lines twice as fine: there are pixels with sub-pixels of both eyes, and a scene that is drawn
/// once cannot show itself on some of a pixel's colours only. 3/3 and the Combiner can.
TEST_F(LineScreenGlTest, FourOneNeedsPixelsOfTheirOwn) {
    if (IsSkipped()) return;
    screen().linesPerM *= 2;
    screen().thicknessM /= 2;
    const gpu::RgbImage three = panelBy(LineScreenMethod::ThreeThree);
    EXPECT_LT(different(three, exact(Sharing::Subpixels)), rounding());
    EXPECT_LT(different(three, combined()), rounding());
    const gpu::RgbImage four = panelBy(LineScreenMethod::FourOne);
    EXPECT_LT(different(four, exact(Sharing::LeftFirst)), rounding());
    std::printf("4/1 at twice the pitch: %.2f %% of sub-pixels are lost\n",
                100 * different(four, three));
    EXPECT_GT(different(four, three), 5 * rounding());
}

/// Other eyes, off the middle and unequally far, as trackers say.
TEST_F(LineScreenGlTest, LinesFollowTheEyes) {
    if (IsSkipped()) return;
    const glm::dvec3 left{-0.21, 0.12, 0.58}, right{-0.15, 0.13, 0.6};
    screen().eyes = {left, right};
    gpu::ScenePipeline& drawn = draw(look);
    const gpu::gl::Texture color(GL_RGBA8, display.width, display.height);
    const gpu::gl::Texture depth(GL_DEPTH_COMPONENT32F, display.width, display.height);
    const gpu::gl::Framebuffer target = gpu::gl::makeFramebuffer(color, &depth);
    gpu::LineScreenViews views(display, look.shading, LineScreenMethod::ThreeThree, {left, right});
    views.render(drawn.model(),
                 gpu::sceneBlock(look, drawn.placement(), display,
                                 static_cast<double>(display.width) / display.height),
                 target.name());
    const gpu::RgbImage seen = gpu::readFramebuffer(target.name(), display.width, display.height);
    const auto viewOf = [&](const glm::dvec3& eye) {
        return drawn.renderEye(eye, display.width, display.height);
    };
    EXPECT_LT(
        different(seen, oracle::interleaved(display, {left, right}, {viewOf(left), viewOf(right)},
                                            Sharing::Subpixels)),
        rounding());
}

} // namespace
} // namespace autostereo::test

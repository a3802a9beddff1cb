// What is changed while a pipeline runs shows what it would have shown with that from the start.
// Kept roots are rounded to 2^-20 of the grid's width: a level may round the other way.

#include "devices/sim/simulation.hpp"
#include "gpu/pipeline.hpp"
#include "gpu/readback.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"

#include <cstdlib>
#include <functional>
#include <numeric>

namespace autostereo::test {
namespace {

constexpr const char* kScene = "sim:person?depth=64x48&color=96x72";

class AdjustGlTest : public GlTest {
  protected:
    /// The fifth picture; `change` comes before it.
    static gpu::RgbImage fifth(const gpu::PipelineParams& params,
                               const std::function<void(gpu::Pipeline&)>& change) {
        const calib::DisplayProfile display = smallLensDisplay(8, 6, 64, 64);
        devices::Input input = devices::sim::openSimulation(kScene);
        gpu::Pipeline pipeline(params, *input.rig, display, display.width, display.height);
        const gpu::gl::Texture color(GL_RGBA8, display.width, display.height);
        const gpu::gl::Framebuffer panel = gpu::gl::makeFramebuffer(color);
        for (int i = 0; i < 5; ++i) {
            if (i == 4) change(pipeline);
            const devices::RgbdFrame frame{read(*input.depth), read(*input.color)};
            pipeline.render(frame, panel.name());
        }
        return gpu::readFramebuffer(panel.name(), display.width, display.height);
    }
    static int beyondOne(const gpu::RgbImage& a, const gpu::RgbImage& b) {
        return std::inner_product(a.pixels.begin(), a.pixels.end(), b.pixels.begin(), 0,
                                  std::plus<>(),
                                  [](int x, int y) { return std::abs(x - y) > 1 ? 1 : 0; });
    }

  private:
    static devices::Frame read(devices::Source& source) {
        return std::get<devices::Frame>(source.read(devices::TimePoint::max()));
    }
};

TEST_F(AdjustGlTest, ScaleIsOnTheNextPicture) {
    const gpu::PipelineParams usual;
    const gpu::RgbImage before = fifth(usual, [](gpu::Pipeline&) {});
    for (const double scale : {0.0, 0.5, 2.0}) {
        gpu::PipelineParams wanted;
        wanted.budget.depthScale = scale;
        const gpu::RgbImage fresh = fifth(wanted, [](gpu::Pipeline&) {});
        const gpu::RgbImage changed = fifth(usual, [&](gpu::Pipeline& pipeline) {
            pipeline.adjust(wanted.budget, wanted.synthesis.method);
        });
        EXPECT_EQ(beyondOne(changed, fresh), 0) << scale;
        EXPECT_GT(beyondOne(changed, before), 100) << scale << ": nothing to be seen";
    }
}

TEST_F(AdjustGlTest, SoIsTheMethod) {
    gpu::PipelineParams wanted;
    for (const gpu::Method method :
         {gpu::Method::Multipass, gpu::Method::Instanced, gpu::Method::Hybrid}) {
        wanted.synthesis.method = method;
        const gpu::RgbImage fresh = fifth(wanted, [](gpu::Pipeline&) {});
        const gpu::RgbImage changed = fifth({}, [&](gpu::Pipeline& pipeline) {
            pipeline.adjust(wanted.budget, method);
            EXPECT_EQ(pipeline.method(), method);
        });
        EXPECT_EQ(changed.pixels, fresh.pixels);
    }
}

TEST_F(AdjustGlTest, FocusMovesToWhatWasAskedFor) {
    gpu::PipelineParams wanted;
    wanted.budget.focusM = 1.25;
    (void)fifth({}, [&](gpu::Pipeline& pipeline) {
        const calib::Framing framing = pipeline.geometry().framing;
        pipeline.adjust(wanted.budget, wanted.synthesis.method);
        EXPECT_EQ(pipeline.geometry().law.focusM, 1.25);
        EXPECT_EQ(pipeline.geometry().framing, framing) << "the picture keeps its frame";
    });
}

} // namespace
} // namespace autostereo::test

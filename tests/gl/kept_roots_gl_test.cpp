// Searching only where something changed shows what searching everywhere shows. Kept roots are
// rounded to 2^-20 of the grid's width, at most 1/1000 of a texel: a level may round the other way.

#include "config/load.hpp"
#include "devices/sim/simulation.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"

#include <cstdlib>
#include <functional>
#include <numeric>

namespace autostereo::test {
namespace {

calib::DisplayProfile smallDisplay(bool upsideDown) {
    calib::DisplayProfile display = smallLensDisplay(8, 6, 64, 64);
    std::get<calib::LookingGlassCalibration>(display.law).flipImageY = upsideDown;
    return display;
}

/// Two pipelines over the same frames: one keeps what it found, the other searches everywhere.
class Twins {
  public:
    Twins(const std::string& uri, const calib::DisplayProfile& display,
          gpu::ViewPositions positions)
        : input_(devices::sim::openSimulation(uri)),
          keeping_(params(positions, true), *input_.rig, display, display.width, display.height),
          searching_(params(positions, false), *input_.rig, display, display.width, display.height),
          panel_(GL_RGBA8, display.width, display.height),
          target_(gpu::gl::makeFramebuffer(panel_)) {}

    void expectSameFrames(int frames) {
        for (int i = 0; i < frames; ++i) {
            const devices::RgbdFrame frame{read(*input_.depth), read(*input_.color)};
            const gpu::RgbImage kept = drawn(keeping_, frame), all = drawn(searching_, frame);
            const auto beyondOne = std::inner_product(
                kept.pixels.begin(), kept.pixels.end(), all.pixels.begin(), 0, std::plus<>(),
                [](int a, int b) { return std::abs(a - b) > 1 ? 1 : 0; });
            ASSERT_EQ(beyondOne, 0) << "frame " << i;
        }
    }
    /// Of the frames so far but the last few, whose counters are under way.
    [[nodiscard]] double keptShare() const { return keeping_.keptShare().value().search; }

  private:
    static gpu::PipelineParams params(gpu::ViewPositions positions, bool keep) {
        gpu::PipelineParams params;
        params.synthesis.positions = positions;
        params.synthesis.keepRoots = keep;
        return params;
    }
    static devices::Frame read(devices::Source& source) {
        return std::get<devices::Frame>(source.read(devices::TimePoint::max()));
    }
    gpu::RgbImage drawn(gpu::Pipeline& pipeline, const devices::RgbdFrame& frame) {
        pipeline.render(frame, target_.name());
        return gpu::readFramebuffer(target_.name(), panel_.width(), panel_.height());
    }

    devices::Input input_;
    gpu::Pipeline keeping_, searching_;
    gpu::gl::Texture panel_;
    gpu::gl::Framebuffer target_;
};

class KeptRootsGlTest : public GlTest {};

TEST_F(KeptRootsGlTest, APersonMovesInFrontOfANoisyCamera) {
    if (IsSkipped()) return;
    Twins twins("sim:person?depth=176x144&color=320x240", smallDisplay(false),
                gpu::ViewPositions::Continuous);
    twins.expectSameFrames(24);
    EXPECT_GT(twins.keptShare(), 0.05);
    EXPECT_LT(twins.keptShare(), 0.95);
}

TEST_F(KeptRootsGlTest, ViewsOneByOneUpsideDown) {
    if (IsSkipped()) return;
    Twins twins("sim:person?depth=176x144&color=320x240&noise=off", smallDisplay(true),
                gpu::ViewPositions::OfViews);
    twins.expectSameFrames(12);
}

TEST_F(KeptRootsGlTest, OfAStillRoomEverythingIsKept) {
    if (IsSkipped()) return;
    Twins twins("sim:room?depth=176x144&color=320x240&noise=off", smallDisplay(false),
                gpu::ViewPositions::Continuous);
    twins.expectSameFrames(20);
    EXPECT_GT(twins.keptShare(), 0.8); // but for the first frames, before their surfaces are held
}

TEST_F(KeptRootsGlTest, ShippedDisplays) {
    if (IsSkipped()) return;
    for (const char* name : {"looking-glass-go", "slanted-8view-1080p", "desorbier-2008-slanted"}) {
        SCOPED_TRACE(name);
        Twins twins("sim:person?depth=176x144&color=320x240", config::loadDisplay(name),
                    gpu::ViewPositions::Continuous);
        twins.expectSameFrames(3);
    }
}

} // namespace
} // namespace autostereo::test

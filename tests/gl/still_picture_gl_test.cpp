// A picture that does not change is not drawn again: then one more drawing must change nothing.

#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"

#include <algorithm>
#include <random>

namespace autostereo::test {
namespace {

class StillPictureGlTest : public GlTest {
  protected:
    static devices::Frame next(devices::Source& source) {
        return std::get<devices::Frame>(source.read(devices::TimePoint::max()));
    }
    /// What has nothing to do with the scene, or half.
    static void disturb(devices::Frame& depth, std::mt19937& random) {
        const auto every = 1 + random() % 3;
        for (std::uint16_t& count : depth.depth())
            if (random() % every == 0) count = static_cast<std::uint16_t>(random() % 8000U);
    }
    gpu::RgbImage drawn(gpu::Pipeline& pipeline, const devices::RgbdFrame& frame) {
        pipeline.render(frame, panel.name());
        return gpu::readFramebuffer(panel.name(), display.width, display.height);
    }

    calib::DisplayProfile display = smallLensDisplay(2, 1, 24, 32);
    std::unique_ptr<gpu::gl::Texture> target;
    gpu::gl::Framebuffer panel;
};

TEST_F(StillPictureGlTest, RestsWhateverWasBefore) {
    if (IsSkipped()) return;
    target = std::make_unique<gpu::gl::Texture>(GL_RGBA8, display.width, display.height);
    panel = gpu::gl::makeFramebuffer(*target);
    const auto source = devices::sim::openSimulation("sim:person?depth=24x18&color=32x18");
    gpu::Pipeline pipeline({}, *source.rig, display, display.width, display.height);
    std::mt19937 random(5);
    for (int round = 0; round < 2; ++round) {
        SCOPED_TRACE(round);
        devices::RgbdFrame frame{next(*source.depth), next(*source.color)};
        for (auto i = random() % 40; i > 0; --i) {
            devices::RgbdFrame other{next(*source.depth), next(*source.color)};
            if (round > 0) disturb(other.depth, random);
            pipeline.render(other, panel.name());
        }
        for (std::uint64_t times = 0; !pipeline.isStill(times); ++times)
            pipeline.render(frame, panel.name());
        const gpu::RgbImage still = drawn(pipeline, frame);
        for (int i = 0; i < 30; ++i)
            ASSERT_EQ(drawn(pipeline, frame).pixels, still.pixels) << "drawing " << i;
    }
}

} // namespace
} // namespace autostereo::test

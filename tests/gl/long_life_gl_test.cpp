// The picture after ten years of uptime is the one of the first day, byte for byte: a scene that is
// followed in time, frames with numbers beyond 2^53.

#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"

namespace autostereo::test {
namespace {

class LongLifeGlTest : public GlTest {};

std::vector<std::vector<std::uint8_t>> picturesFrom(devices::Duration start, std::uint64_t first) {
    const calib::DisplayProfile display = smallLensDisplay(2, 1, 24, 32);
    const gpu::gl::Texture target(GL_RGBA8, display.width, display.height);
    const gpu::gl::Framebuffer panel = gpu::gl::makeFramebuffer(target);
    const auto input = devices::sim::openSimulation("sim:person?depth=24x18&color=32x18&fps=5");
    gpu::PipelineParams params;
    params.budget.follow = true;
    gpu::Pipeline pipeline(params, *input.rig, display, display.width, display.height);
    std::vector<std::vector<std::uint8_t>> pictures;
    for (int i = 0; i < 20; ++i) {
        devices::RgbdFrame frame{
            std::get<devices::Frame>(input.depth->read(devices::TimePoint::max())),
            std::get<devices::Frame>(input.color->read(devices::TimePoint::max()))};
        for (devices::Frame* part : {&frame.depth, &frame.color}) {
            part->metadata().capturedAt += start;
            part->metadata().sequence += first;
        }
        frame.index = first + static_cast<std::uint64_t>(i);
        pipeline.render(frame, panel.name());
        pictures.push_back(
            gpu::readFramebuffer(panel.name(), display.width, display.height).pixels);
    }
    return pictures;
}

TEST_F(LongLifeGlTest, ThePicturesAreThoseOfTheFirstDay) {
    if (IsSkipped()) return;
    constexpr devices::Duration kTenYears = std::chrono::hours(10L * 365 * 24 + 1);
    const auto expected = picturesFrom({}, 0);
    EXPECT_NE(expected.front(), expected.back()) << "somebody moves";
    EXPECT_EQ(picturesFrom(kTenYears, (1ULL << 53U) - 2), expected);
}

} // namespace
} // namespace autostereo::test

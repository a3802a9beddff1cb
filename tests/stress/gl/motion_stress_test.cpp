// Searching only where something moved fills the panel with the bytes that searching everywhere
// does: things of any size that move, come and go, in front and behind, in depth and in colour.

#include "gpu/depth_mesh.hpp"
#include "gpu/views/direct_synthesis.hpp"
#include "tests/stress/campaign.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"

#include <cstdio>
#include <random>

namespace autostereo::test {
namespace {

constexpr int kPanelWidth = 192, kPanelHeight = 128;
constexpr int kColumns = 48, kRows = 32;

/// A layer's depth or colours, in which rectangles are overwritten.
template<class Texel>
class Canvas {
  public:
    Canvas(GLenum internalFormat, GLenum format, GLenum type, Texel start)
        : format_(format), type_(type), texture_(internalFormat, kColumns, kRows) {
        texture_.setFilter(internalFormat == GL_RGBA8 ? GL_LINEAR : GL_NEAREST);
        fill(0, 0, kColumns, kRows, start);
    }
    void fill(int x, int y, int width, int height, Texel texel) {
        const std::vector<Texel> texels(
            static_cast<std::size_t>(width) * static_cast<std::size_t>(height), texel);
        glTextureSubImage2D(texture_.name(), 0, x, y, width, height, format_, type_, texels.data());
    }
    [[nodiscard]] const gpu::gl::Texture& texture() const { return texture_; }

  private:
    GLenum format_, type_;
    gpu::gl::Texture texture_;
};

/// Two layers in which something happens at random.
class MovingLayers {
  public:
    [[nodiscard]] gpu::CyclopeanScene scene() const {
        return {depth_.texture(), color_.texture(), behind_.texture(), behindColor_.texture()};
    }
    void move() {
        constexpr int kMost = 3;
        for (int i = integer(0, kMost); i > 0; --i) {
            const int width = integer(1, integer(1, kColumns)), height = integer(1, kRows);
            const int x = integer(0, kColumns - width), y = integer(0, kRows - height);
            const float metres = std::exp(uniform(-0.7F, 1.5F));
            switch (integer(0, 4)) {
            case 0:
                behind_.fill(x, y, width, height, metres);
                break;
            case 1:
                color_.fill(x, y, width, height, static_cast<std::uint32_t>(random_()));
                break;
            case 2:
                behindColor_.fill(x, y, width, height, static_cast<std::uint32_t>(random_()));
                break;
            default:
                depth_.fill(x, y, width, height, integer(0, 9) == 0 ? 0 : metres);
            }
        }
    }

  private:
    int integer(int least, int most) { return std::uniform_int_distribution(least, most)(random_); }
    float uniform(float least, float most) {
        return std::uniform_real_distribution(least, most)(random_);
    }

    std::mt19937 random_{11};
    Canvas<float> depth_{GL_R32F, GL_RED, GL_FLOAT, 1}, behind_{GL_R32F, GL_RED, GL_FLOAT, 3};
    Canvas<std::uint32_t> color_{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 0x406080},
        behindColor_{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 0x201008};
};

/// A way to fill the panel.
struct Filled {
    explicit Filled(const calib::DisplayProfile& display)
        : target(GL_RGBA8, kPanelWidth, kPanelHeight), panel(gpu::gl::makeFramebuffer(target)),
          direct({}, display, kPanelWidth, kPanelHeight) {}

    std::vector<std::uint8_t> show(const gpu::CyclopeanScene& scene) {
        direct.prepare(scene);
        direct.show(scene, panel.name());
        return gpu::readFramebuffer(panel.name(), kPanelWidth, kPanelHeight).pixels;
    }
    /// A scene of another size: nothing that was found holds for the next one.
    void forget() {
        const gpu::gl::Texture other(GL_R32F, 1, 1);
        direct.prepare({other, other, other, other});
    }

    gpu::gl::Texture target;
    gpu::gl::Framebuffer panel;
    gpu::DirectSynthesis direct;
};

class MotionStressTest : public GlTest {};

TEST_F(MotionStressTest, WhatIsSkippedChangesNoByte) {
    if (IsSkipped()) return;
    const auto input = devices::sim::openSimulation("sim:room?depth=16x16&color=48x32");
    calib::DisplayProfile display = smallLensDisplay(8, 1, 64, 64);
    display.disparityNear = 0.2; // a ray passes many blocks of four texels
    display.disparityFar = -0.2;
    const gpu::PipelineParams params;
    gpu::SceneGeometry geometry = gpu::sceneGeometry(*input.rig, display, params, 1.5, 1.0);
    geometry.grid = {kColumns, kRows, 0.2, 0.05};
    gpu::DepthMesh mesh(params.mesh, *input.rig); // fills the block that all passes share
    const gpu::gl::Texture noDepth(GL_R16UI, 1, 1);
    mesh.build(noDepth, 0.001, geometry);
    MovingLayers layers;
    Filled skipping(display), everywhere(display);
    const std::uint64_t motions = campaign(400, 10'000);
    for (std::uint64_t i = 0; i < motions; ++i) {
        layers.move();
        everywhere.forget();
        ASSERT_EQ(skipping.show(layers.scene()), everywhere.show(layers.scene())) << "motion " << i;
    }
    const double kept = skipping.direct.keptShare().value_or(gpu::KeptShare{}).search;
    EXPECT_GT(kept, 0.2) << "or nothing was tested";
    EXPECT_EQ(everywhere.direct.keptShare().value_or(gpu::KeptShare{1, 1}).search, 0.0);
    std::printf("%llu motions, %.0f %% of the panel was not searched anew\n",
                static_cast<unsigned long long>(motions), 100 * kept);
}

} // namespace
} // namespace autostereo::test

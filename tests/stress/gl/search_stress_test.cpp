// The search against double precision on layers that no camera would deliver: any depth beside any
// other, grids of a texel, disparities of a third of the panel, one view and a thousand.

#include "gpu/depth_mesh.hpp"
#include "gpu/views/direct_synthesis.hpp"
#include "tests/oracle/panel_differences.hpp"
#include "tests/stress/campaign.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_search_input.hpp"

#include <cstdio>
#include <random>

namespace autostereo::test {
namespace {

constexpr int kPanelWidth = 24, kPanelHeight = 16;
constexpr std::array kViewCounts{1, 2, 8, 48, 1000};

/// Everything of one scene but its display, from a seed.
class RandomLayers {
  public:
    RandomLayers(std::uint64_t seed, const calib::SensorRig& rig, gpu::SceneGeometry geometry)
        : random_(seed), rig_(rig), geometry_(std::move(geometry)) {
        geometry_.grid.columns = size(24);
        geometry_.grid.rows = size(12);
        geometry_.grid.marginU = uniform(0, 0.4);
        geometry_.grid.marginV = uniform(0, 0.1);
        const bool flat = integer(0, 19) == 0; // d_min = d_max
        geometry_.law.nearest = flat ? 0 : uniform(0, 0.37);
        geometry_.law.farthest = flat ? 0 : uniform(-0.37, 0);
        geometry_.law.scale = std::exp(uniform(-3, 3));
        const int columns = geometry_.grid.columns, rows = geometry_.grid.rows;
        depth_ = depths(columns, rows, 0.2);
        backgroundDepth_ = depths(columns, rows, 0);
        color_ = colors(rig.color.intrinsics.width, rig.color.intrinsics.height);
        backgroundColor_ = colors(columns, rows);
    }

    [[nodiscard]] const gpu::SceneGeometry& geometry() const { return geometry_; }
    [[nodiscard]] gpu::CyclopeanScene scene() const {
        return {depth_, color_, backgroundDepth_, backgroundColor_};
    }
    [[nodiscard]] oracle::SearchInput input() const {
        return searchInput(rig_, geometry_, scene(), readPicture(color_));
    }

  private:
    double uniform(double least, double most) {
        return std::uniform_real_distribution(least, most)(random_);
    }
    int integer(int least, int most) { return std::uniform_int_distribution(least, most)(random_); }
    /// Often one.
    int size(int most) { return integer(0, 7) == 0 ? 1 : integer(1, most); }

    /// Surfaces that go on, steps, holes.
    gpu::gl::Texture depths(int columns, int rows, double holes) {
        std::vector<float> metres;
        double depth = 1;
        for (int i = 0; i < columns * rows; ++i) {
            depth = uniform(0, 1) < 0.2 ? std::exp(uniform(-2, 4.6)) : depth * uniform(0.97, 1.03);
            metres.push_back(uniform(0, 1) < holes ? 0.0F : static_cast<float>(depth));
        }
        gpu::gl::Texture texture(GL_R32F, columns, rows);
        glTextureSubImage2D(texture.name(), 0, 0, 0, columns, rows, GL_RED, GL_FLOAT,
                            metres.data());
        return texture;
    }
    gpu::gl::Texture colors(int columns, int rows) {
        std::vector<std::uint32_t> texels;
        for (int i = 0; i < columns * rows; ++i)
            texels.push_back(static_cast<std::uint32_t>(random_()));
        gpu::gl::Texture texture(GL_RGBA8, columns, rows);
        texture.setFilter(GL_LINEAR);
        glTextureSubImage2D(texture.name(), 0, 0, 0, columns, rows, GL_RGBA, GL_UNSIGNED_BYTE,
                            texels.data());
        return texture;
    }

    std::mt19937_64 random_;
    calib::SensorRig rig_;
    gpu::SceneGeometry geometry_;
    gpu::gl::Texture depth_, backgroundDepth_, color_, backgroundColor_;
};

/// A display and the program that fills it; scenes take turns.
struct Shown {
    Shown(int views, gpu::ViewPositions positions)
        : display(smallLensDisplay(views, 1, 64, 64)), target(GL_RGBA8, kPanelWidth, kPanelHeight),
          panel(gpu::gl::makeFramebuffer(target)) {
        display.width = kPanelWidth;
        display.height = kPanelHeight;
        display.optics.kind = calib::Optics::Kind::Lens;
        gpu::PipelineParams params;
        params.synthesis.positions = positions;
        direct = std::make_unique<gpu::DirectSynthesis>(params, display, kPanelWidth, kPanelHeight);
        truth = std::make_unique<oracle::SearchedPanel>(display, kPanelWidth, kPanelHeight,
                                                        positions, 1.0 / 3);
    }

    calib::DisplayProfile display;
    gpu::gl::Texture target;
    gpu::gl::Framebuffer panel;
    std::unique_ptr<gpu::DirectSynthesis> direct;
    std::unique_ptr<oracle::SearchedPanel> truth;
};

class SearchStressTest : public GlTest {};

TEST_F(SearchStressTest, AnySceneIsSeenAsInDoublePrecision) {
    if (IsSkipped()) return;
    std::vector<Shown> displays;
    for (const int views : kViewCounts)
        for (const auto positions : {gpu::ViewPositions::OfViews, gpu::ViewPositions::Continuous})
            displays.emplace_back(views, positions);
    devices::Input input = devices::sim::openSimulation("sim:room?depth=16x16&color=32x24");
    const gpu::PipelineParams params;
    gpu::DepthMesh mesh(params.mesh, *input.rig); // fills the block that all passes share
    const gpu::gl::Texture noDepth(GL_R16UI, 1, 1);
    oracle::Differences all;
    const std::uint64_t scenes = campaign(500, 100'000);
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        Shown& shown = displays[seed % displays.size()];
        const RandomLayers layers(seed, *input.rig,
                                  gpu::sceneGeometry(*input.rig, shown.display, params, 1.5, 1.0));
        mesh.build(noDepth, 0.001, layers.geometry());
        shown.direct->prepare(layers.scene());
        shown.direct->show(layers.scene(), shown.panel.name());
        const oracle::Differences found =
            oracle::compare(gpu::readFramebuffer(shown.panel.name(), kPanelWidth, kPanelHeight),
                            layers.input(), *shown.truth, 1);
        ASSERT_EQ(found.unexplained, 0U) << "seed " << seed << ", largest " << found.largest;
        all.add(found);
    }
    // Rounding to 8 bits and the filter's 8-bit weights leave 56 dB.
    EXPECT_GE(all.psnr(), 55.5);
    std::printf("%llu scenes: %.2f dB, more than 2/255: %zu of %zu, each a tie\n",
                static_cast<unsigned long long>(scenes), all.psnr(), all.overTwo, all.samples);
}

} // namespace
} // namespace autostereo::test

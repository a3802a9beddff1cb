// Each fusion pass on the GPU against double precision, fed with what the pass before it gave.

#include "tests/oracle/fusion_oracle.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"

#include <cmath>

namespace autostereo::test {
namespace {

template<std::size_t Channels>
std::vector<std::array<float, Channels>> readTexels(const gpu::gl::Texture& texture) {
    constexpr std::array<GLenum, 4> kFormats{GL_RED, GL_RG, GL_RGB, GL_RGBA};
    std::vector<std::array<float, Channels>> texels(static_cast<std::size_t>(texture.width()) *
                                                    static_cast<std::size_t>(texture.height()));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture.name(), 0, kFormats[Channels - 1], GL_FLOAT,
                      static_cast<GLsizei>(texels.size() * Channels * sizeof(float)),
                      texels.data());
    return texels;
}

oracle::DepthGrid readDepthGrid(const gpu::gl::Texture& texture) {
    oracle::DepthGrid grid(texture.width(), texture.height());
    const auto texels = readTexels<1>(texture);
    for (std::size_t i = 0; i < texels.size(); ++i)
        grid.texels[i] = static_cast<double>(texels[i][0]);
    return grid;
}

class FusionGlTest : public GlTest, public testing::WithParamInterface<const char*> {
  protected:
    void fuse() {
        pair = simulate(GetParam(), 2);
        pipeline = std::make_unique<gpu::Pipeline>(params, pair.rig, display, display.width,
                                                   display.height);
        pipeline->prepare(pair.frame);
        in.rig = pair.rig;
        in.geometry = pipeline->geometry();
        in.color = colorPicture(pair.frame.color);
        const gpu::FillBlock block = gpu::fillBlock(params.fusion, pair.rig, in.geometry);
        in.fillReach = block.reach.x;
        in.edgeReach = block.reach.y;
        in.unsure = block.reach.z;
        in.band = block.reach.w;
        ASSERT_GT(in.band, 0) << "the colour camera is the finer one here";
    }
    [[nodiscard]] const gpu::Fusion& fusion() const { return pipeline->fusion(); }

    gpu::PipelineParams params;
    calib::DisplayProfile display = smallLensDisplay(2, 1, 48, 64);
    CapturedPair pair = simulate("sim:room?depth=16x16&color=16x16");
    std::unique_ptr<gpu::Pipeline> pipeline;
    oracle::FusionInput in;
};

double shareOff(const oracle::DepthGrid& a, const oracle::DepthGrid& b) {
    std::size_t off = 0;
    for (std::size_t i = 0; i < a.texels.size(); ++i)
        if (!(std::abs(a.texels[i] - b.texels[i]) <= 1e-5 * b.texels[i])) ++off;
    return static_cast<double>(off) / static_cast<double>(a.texels.size());
}

/// The filter's colours have 8-bit weights: of two surfaces whose colours fit equally well the
/// other may be chosen (measured: 0.01 % of texels).
constexpr double kTies = 1e-3;
/// Float against double where a ratio of depths is compared with the cut (measured: none).
constexpr double kRounding = 1e-4;

TEST_P(FusionGlTest, DepthIsFilledAsTheOracleDoes) {
    if (IsSkipped()) return;
    fuse();
    const auto measured = readDepthGrid(fusion().measuredDepth());
    const auto sure = readDepthGrid(fusion().holes().sureDepth());
    EXPECT_LE(shareOff(sure, oracle::sureDepth(in, measured)), kRounding);
    const auto filled = readDepthGrid(fusion().holes().depth());
    EXPECT_LE(shareOff(filled, oracle::filledDepth(in, measured, sure)), kTies);
}

TEST_P(FusionGlTest, WhatIsHiddenIsClaimedAndContinued) {
    if (IsSkipped()) return;
    fuse();
    const auto sure = readDepthGrid(fusion().holes().sureDepth());
    const auto filled = readDepthGrid(fusion().holes().depth());
    const auto claims = oracle::claimsOf(in, filled);
    const auto claimed = readTexels<2>(fusion().background().claims());
    std::size_t wrong = 0, hidden = 0;
    for (std::size_t i = 0; i < claimed.size(); ++i) {
        const double z = claims.texels[i].z;
        hidden += z > 0 ? 1 : 0;
        wrong += std::abs(static_cast<double>(claimed[i][0]) - z) > 1e-5 * z ? 1 : 0;
    }
    EXPECT_GT(hidden, claimed.size() / 50);
    EXPECT_LE(wrong, claimed.size() / 10000);

    const auto expected = oracle::background(in, sure, filled, claims);
    EXPECT_LE(shareOff(readDepthGrid(fusion().background().depth()), expected.depth), kRounding);
    const auto colors = readTexels<3>(fusion().background().color());
    std::size_t off = 0;
    for (std::size_t i = 0; i < colors.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            off += std::abs(static_cast<double>(colors[i][c]) - expected.color.texels[i][c]) >
                           1.51 / 255 // rounded to 8 bits, from colours filtered with 8-bit weights
                       ? 1
                       : 0;
    EXPECT_LE(off, colors.size() * 3 / 10000);
}

/// Corners of the scene's quads: on the grid's lines, their depth between that of the texels
/// around.
TEST_P(FusionGlTest, QuadsMeetWhereTexelsAreOneSurface) {
    if (IsSkipped()) return;
    fuse();
    const auto depth = readDepthGrid(fusion().holes().depth());
    gpu::LayerMesher mesher;
    const auto points = readTexels<4>(mesher.build(pipeline->scene()).scene.points);
    const int stride = 2 * depth.columns;
    for (int y = 0; y < depth.rows; y += 3)
        for (int x = 0; x < depth.columns; ++x)
            for (int corner = 0; corner < 4 && depth.at(x, y) > 0; ++corner) {
                const int i = corner & 1, j = corner >> 1;
                double inverse = 0, disparity = 0;
                int parts = 0;
                for (int n = 0; n < 4; ++n) {
                    const double z = depth.at(x + i - (n & 1), y + j - (n >> 1));
                    if (!(z > 0) || !oracle::oneSurface(in, z, depth.at(x, y))) continue;
                    inverse += 1 / z;
                    disparity += oracle::disparity(in.geometry.law, z);
                    ++parts;
                }
                const int vertex = (2 * y + j) * stride + 2 * x + i;
                const auto& point = points[static_cast<std::size_t>(vertex)];
                const glm::dvec2 uv = in.geometry.grid.panelFromTexel({x + i - 0.5, y + j - 0.5});
                ASSERT_NEAR(static_cast<double>(point[0]), uv.x, 1e-6);
                ASSERT_NEAR(static_cast<double>(point[1]), uv.y, 1e-6);
                ASSERT_NEAR(static_cast<double>(point[2]), disparity / parts, 1e-6);
                ASSERT_NEAR(static_cast<double>(point[3]), parts / inverse, 1e-5);
            }
}

INSTANTIATE_TEST_SUITE_P(Scenes, FusionGlTest,
                         testing::Values("sim:room?depth=176x144&color=640x360&noise=off",
                                         "sim:person?depth=176x144&color=640x360"));

} // namespace
} // namespace autostereo::test

// Mesh and layers on the GPU against double precision, and the pixel classes that real sensors
// give.

#include "devices/frame_pool.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <random>

namespace autostereo::test {
namespace {

std::vector<glm::vec4> readPoints(const gpu::MeshLayer& layer) {
    std::vector<glm::vec4> points(static_cast<std::size_t>(layer.points.width()) *
                                  static_cast<std::size_t>(layer.points.height()));
    glGetTextureImage(layer.points.name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(points.size() * sizeof(glm::vec4)), points.data());
    return points;
}

std::size_t drawnTriangles(const gpu::MeshLayer& layer) {
    std::vector<GLuint> indices(static_cast<std::size_t>(layer.indexCount));
    glGetNamedBufferSubData(layer.indices.name(), 0,
                            static_cast<GLsizeiptr>(indices.size() * sizeof(GLuint)),
                            indices.data());
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        if (indices[i] != indices[i + 1]) ++drawn;
    return drawn;
}

class DepthMeshGlTest : public GlTest {
  protected:
    /// A frame of one depth, `counts` long, in front of a grey colour picture.
    void render(int width, int height, const std::vector<std::uint16_t>& counts) {
        frame.depth = *pool.acquire({devices::PixelFormat::Depth16, width, height});
        frame.color = *pool.acquire({devices::PixelFormat::Rgba8, 64, 48});
        std::copy(counts.begin(), counts.end(), frame.depth.depth().begin());
        std::fill(frame.color.pixels().begin(), frame.color.pixels().end(), std::byte{90});
        const calib::SensorRig rig = devices::sim::simulatedRig(width, height, 64, 48);
        pipeline = std::make_unique<gpu::Pipeline>(params, rig, display, 96, 128);
        pipeline->prepare(frame);
        mesher = std::make_unique<gpu::LayerMesher>();
    }
    const gpu::MeshLayers& layers() { return mesher->build(pipeline->scene()); }

    gpu::PipelineParams params;
    calib::DisplayProfile display = smallLensDisplay(2, 1, 48, 64);
    devices::FramePool pool{4};
    devices::RgbdFrame frame;
    std::unique_ptr<gpu::Pipeline> pipeline;
    std::unique_ptr<gpu::LayerMesher> mesher;
};

/// Float against double: u, v and the texture coordinate come from a few dozen operations on
/// values near one, so some 1e-6; the texture coordinate goes through the distortion polynomial.
TEST_F(DepthMeshGlTest, NodesAgreeWithTheOracle) {
    const CapturedPair pair = simulate("sim:room?depth=176x144&color=640x360");
    pipeline = std::make_unique<gpu::Pipeline>(params, pair.rig, display, 96, 128);
    pipeline->prepare(pair.frame);
    const oracle::MeshInput input = oracleInput(pair, *pipeline, params);
    const oracle::Layer mesh = oracle::meshLayer(input);
    const auto points = readPoints(pipeline->mesh().layer());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& node = mesh.nodes[i];
        ASSERT_EQ(node.has_value(), points[i].w > 0);
        if (!node) continue;
        ASSERT_NEAR(points[i].x, node->u, 4e-6);
        ASSERT_NEAR(points[i].y, node->v, 4e-6);
        ASSERT_NEAR(points[i].z, node->d, 1e-6);
        ASSERT_NEAR(points[i].w, node->z, 2e-6);
    }
    EXPECT_EQ(drawnTriangles(pipeline->mesh().layer()), mesh.triangles.size());
}

TEST_F(DepthMeshGlTest, AStepIsCutAndASlopeIsNot) {
    constexpr int kWidth = 32, kHeight = 8;
    std::vector<std::uint16_t> step, slope;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            step.push_back(x < kWidth / 2 ? 1000 : 1051); // 5.1 % against a cut of 5 %
            slope.push_back(static_cast<std::uint16_t>(1000 + 40 * x));
        }
    render(kWidth, kHeight, slope);
    const std::size_t whole = 2 * (kWidth - 1) * (kHeight - 1);
    EXPECT_EQ(drawnTriangles(pipeline->mesh().layer()), whole);
    params.mesh.farthestM = 10;
    render(kWidth, kHeight, step);
    EXPECT_EQ(drawnTriangles(pipeline->mesh().layer()), whole - 2 * (kHeight - 1))
        << "one column of cells bridges the step";
}

TEST_F(DepthMeshGlTest, NoMeasurementMakesNoNodeButABackground) {
    params.mesh.farthestM = 10;
    for (const int count : {0, 65535, 1, 60000}) {
        render(20, 13, std::vector<std::uint16_t>(20 * 13, static_cast<std::uint16_t>(count)));
        EXPECT_EQ(drawnTriangles(pipeline->mesh().layer()), 0U) << count;
        EXPECT_GT(drawnTriangles(layers().background), 0U) << count;
    }
}

/// Grids down to one pixel, all kinds of values: every output stays finite.
TEST_F(DepthMeshGlTest, AnyGridAndAnyValueStaysFinite) {
    std::mt19937 random(11);
    constexpr std::array<std::uint16_t, 8> kValues{0, 1, 149, 150, 1000, 9999, 65534, 65535};
    constexpr std::array<std::array<int, 2>, 6> kSizes{
        {{1, 1}, {1, 9}, {9, 1}, {2, 2}, {5, 4}, {37, 23}}};
    for (const auto& [width, height] : kSizes) {
        std::vector<std::uint16_t> counts;
        std::generate_n(std::back_inserter(counts), width * height,
                        [&] { return kValues[random() % 8]; });
        render(width, height, counts);
        const gpu::MeshLayers& drawn = layers();
        for (const gpu::MeshLayer* layer : {&drawn.scene, &drawn.background})
            for (const glm::vec4& point : readPoints(*layer))
                ASSERT_TRUE(std::isfinite(point.x + point.y + point.z + point.w));
    }
}

} // namespace
} // namespace autostereo::test

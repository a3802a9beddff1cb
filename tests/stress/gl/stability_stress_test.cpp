// Whatever cameras deliver, and whatever they are: no crash, no GL error, nothing infinite or NaN,
// and every pixel of a view shows the scene or its background.

#include "gpu/depth_registration.hpp"
#include "gpu/exports.hpp"
#include "gpu/views/direct_synthesis.hpp"
#include "gpu/views/layer_mesher.hpp"
#include "tests/stress/campaign.hpp"
#include "tests/stress/gl/hostile_scenes.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace autostereo::test {
namespace {

class StabilityStressTest : public GlTest {};

/// Numbers of a float texture that are none.
std::size_t notFinite(const gpu::gl::Texture& texture) {
    std::vector<float> numbers(4 * static_cast<std::size_t>(texture.width()) *
                               static_cast<std::size_t>(texture.height()));
    glGetTextureImage(texture.name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(numbers.size() * sizeof(float)), numbers.data());
    return static_cast<std::size_t>(
        std::count_if(numbers.begin(), numbers.end(), [](float n) { return !std::isfinite(n); }));
}

void expectFinite(const gpu::Pipeline& pipeline) {
    const gpu::Fusion& fusion = pipeline.fusion();
    const gpu::BackgroundLayer& background = fusion.background();
    gpu::LayerMesher mesher;
    const gpu::MeshLayers& layers = mesher.build(pipeline.scene());
    const std::pair<const char*, const gpu::gl::Texture&> textures[] = {
        {"mesh points", pipeline.mesh().layer().points},
        {"mesh sources", pipeline.mesh().layer().sources},
        {"measured", fusion.measuredDepth()},
        {"sure", fusion.holes().sureDepth()},
        {"filled", fusion.holes().depth()},
        {"claims", background.claims()},
        {"background depth", background.depth()},
        {"memory", background.memory().depth()},
        {"scene points", layers.scene.points},
        {"scene sources", layers.scene.sources},
        {"background points", layers.background.points},
        {"background sources", layers.background.sources},
    };
    for (const auto& [name, texture] : textures)
        EXPECT_EQ(notFinite(texture), 0U) << name;
}

/// Every level between the darkest and the brightest of the colour picture; filters round.
void expectSceneOrBackground(const std::vector<std::uint8_t>& levels, const char* what) {
    const auto outside = std::count_if(levels.begin(), levels.end(), [](int level) {
        return level < HostileScene::kDarkest - 1 || level > HostileScene::kBrightest + 1;
    });
    EXPECT_EQ(outside, 0) << what << ": samples that are neither scene nor background";
}

gpu::RgbImage readAtlas(const gpu::Pipeline& pipeline) {
    const gpu::AtlasLayout& layout = pipeline.atlas()->layout();
    return gpu::readFramebuffer(pipeline.atlas()->framebuffer(), layout.width(), layout.height());
}

/// The same scene by the search.
void expectDirectShowsScene(const gpu::Pipeline& pipeline, const HostileScene& scene,
                            const calib::DisplayProfile& display) {
    constexpr int kWidth = 96, kHeight = 72;
    const gpu::gl::Texture target(GL_RGBA8, kWidth, kHeight);
    const gpu::gl::Framebuffer panel = gpu::gl::makeFramebuffer(target);
    gpu::DirectSynthesis direct(scene.params, display, kWidth, kHeight);
    direct.prepare(pipeline.scene());
    direct.show(pipeline.scene(), panel.name());
    expectSceneOrBackground(gpu::readFramebuffer(panel.name(), kWidth, kHeight).pixels, "panel");
}

/// What `render` exports beside views, once a scene.
void exportAll(HostileScene& scene, const gpu::Pipeline& pipeline,
               const calib::DisplayProfile& display) {
    const glm::dvec3 offset{scene.uniform(-0.5, 0.5), scene.uniform(-0.5, 0.5),
                            scene.uniform(-0.5, 0.5)};
    gpu::MovedCamera moved(scene.params, scene.rig, offset);
    static_cast<void>(moved.render(pipeline));
    static_cast<void>(gpu::renderEye(pipeline, scene.params, display, offset + 0.5, 40, 30));
    gpu::DepthRegistration registration(scene.params.mesh, scene.params.registration, scene.rig);
    registration.render(pipeline.depth(), 0.001, 80, 45);
    EXPECT_EQ(notFinite(registration.metres()), 0U) << "registered depth";
}

TEST_F(StabilityStressTest, NothingThatCamerasDeliverBreaksIt) {
    if (IsSkipped()) return;
    constexpr std::uint64_t kCombinations = kGridSizes.size() * kPixelClasses.size();
    // The share walks through sizes and classes with a step that has no factor of their number.
    const std::uint64_t cases = campaign(12, 4 * kCombinations);
    const std::uint64_t step = campaign(11, 1);
    const calib::DisplayProfile display = smallLensDisplay(3, 1, 40, 30);
    for (std::uint64_t i = 0; i < cases; ++i) {
        const std::uint64_t number = i * step % kCombinations;
        HostileScene scene(i, kGridSizes[number % kGridSizes.size()],
                           kPixelClasses[number / kGridSizes.size()]);
        SCOPED_TRACE("case " + std::to_string(i) + ": " + scene.name());
        scene.params.synthesis.method = gpu::Method::Instanced;
        gpu::Pipeline pipeline(scene.params, scene.rig, display, 96, 72);
        for (int frame = 0; frame < 3; ++frame) {
            pipeline.prepare(scene.next());
            expectFinite(pipeline);
            expectSceneOrBackground(readAtlas(pipeline).pixels, "views");
        }
        expectDirectShowsScene(pipeline, scene, display);
        if (i % 4 == 0) exportAll(scene, pipeline, display);
        if (HasFailure()) return; // the first case is the one to look at
    }
}

} // namespace
} // namespace autostereo::test

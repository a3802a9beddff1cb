#include "gpu/scene/scene_surfaces.hpp"

#include "calib/disparity_law.hpp"
#include "calib/view_map.hpp"
#include "gpu/gl/error.hpp"
#include "gpu/scene/scene_views.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace autostereo::gpu {

namespace {

/// Texels of one surface differ less: that many of the outermost view.
constexpr double kEdgeTexels = 2;

struct Lineup {
    double first, step; ///< b
    int count;
};

Lineup lineup(const calib::DisplayProfile& display, int references) {
    const int count = std::min(references, display.views);
    const double first = calib::viewPosition(display, 0);
    const double last = calib::viewPosition(display, display.views - 1);
    return {first, count > 1 ? (last - first) / (count - 1) : 0, count};
}

double disparityOf(double height, const calib::DisplayProfile& display) {
    return calib::fanHalfWidth(display) * height / (display.viewingDistanceM - height);
}

SurfacesBlock blockOf(const calib::DisplayProfile& display, const ScenePlacement& placement,
                      const calib::QuiltLayout& tiles, const Lineup& places,
                      const std::array<double, 3>& clearColor) {
    const double edge = kEdgeTexels / tiles.tileWidth;
    constexpr double kSlack = 1.01; // as SceneBlock::range
    const double nearest = disparityOf(kSlack * placement.nearM, display);
    const double nothing = disparityOf(kSlack * placement.farM, display) - 1.5 * edge;
    // Any place of the fan from both references beside it; phases go half a view past the last.
    const double reach = std::max(places.step, 1.0 / display.views) + 1.0 / display.views;
    const double widest = std::max(std::abs(nearest), std::abs(nothing));
    const int margin = static_cast<int>(std::ceil(reach * widest * tiles.tileWidth)) + 2;
    SurfacesBlock block;
    block.lattice = {tiles.tileWidth + 2 * margin, margin, tiles.tileHeight, places.count};
    block.lineup = {places.first, places.step, edge, places.step > 0 ? 1 / places.step : 0};
    block.span = {nearest, nothing, 0, 0};
    block.backdrop = {clearColor[0], clearColor[1], clearColor[2], 1};
    return block;
}

gl::Framebuffer makeTarget(const gl::Texture& disparities, const gl::Texture& surfaces,
                           const gl::Texture& depth, int layer) {
    constexpr std::array<GLenum, 2> kTargets{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    gl::Framebuffer framebuffer(name);
    glNamedFramebufferTextureLayer(name, kTargets[0], disparities.name(), 0, layer);
    glNamedFramebufferTextureLayer(name, kTargets[1], surfaces.name(), 0, layer);
    glNamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, depth.name(), 0);
    glNamedFramebufferDrawBuffers(name, 2, kTargets.data());
    if (glCheckNamedFramebufferStatus(name, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw GlError("gl: a reference viewpoint of " + std::to_string(depth.width()) + "x" +
                      std::to_string(depth.height()) +
                      " is not complete: does the driver allow this size?");
    return framebuffer;
}

gl::Program makeProgram(SceneShading shading) {
    std::vector<std::string> defines = definesOf(shading);
    defines.insert(defines.end(), {"DISPARITY", "SURFACES"});
    return gl::Program({"scene_view.vert", "scene_view.frag"}, defines);
}

std::vector<glm::dvec3> eyesOf(const calib::DisplayProfile& display, const Lineup& places) {
    std::vector<glm::dvec3> eyes;
    for (int i = 0; i < places.count; ++i)
        eyes.push_back(fanEye(display, places.first + i * places.step));
    return eyes;
}

} // namespace

SceneSurfaces::SceneSurfaces(const calib::DisplayProfile& display, const ScenePlacement& placement,
                             SceneShading shading, const calib::QuiltLayout& tile, int references,
                             const std::array<double, 3>& clearColor)
    : program_(makeProgram(shading)), findPeaks_({"scene_peaks.comp"}) {
    const Lineup places = lineup(display, references);
    block_ = blockOf(display, placement, tile, places, clearColor);
    const int width = block_.lattice.x, height = block_.lattice.z;
    eyes_ = makeEyes(eyesOf(display, places));
    disparities_ = gl::Texture(GL_R32F, width, height, places.count);
    surfaces_ = gl::Texture(GL_RGBA32UI, width, height, places.count);
    depth_ = gl::Texture(GL_DEPTH_COMPONENT32F, width, height);
    peaks_ = gl::Texture(GL_R32F, (width + kPeakBlock - 1) / kPeakBlock, height, places.count);
    for (int i = 0; i < places.count; ++i)
        framebuffers_.push_back(makeTarget(disparities_, surfaces_, depth_, i));
}

void SceneSurfaces::draw(const SceneModel& model, SceneBlock block) {
    const std::array<float, 4> nothing{block_.span.y, 0, 0, 0};
    const std::array<GLuint, 4> nobody{0, 0, 0, 0};
    const float farthest = 1;
    const auto shown = static_cast<float>(block_.lattice.x - 2 * block_.lattice.y);
    block.form.x *= static_cast<float>(block_.lattice.x) / shown; // the margin
    glBindTextureUnit(2, eyes_.name());
    glViewport(0, 0, block_.lattice.x, block_.lattice.z);
    program_.use();
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE); // as scene_eyes.glsl has it
    const DepthTest depthTest;
    for (std::size_t i = 0; i < framebuffers_.size(); ++i) {
        const GLuint target = framebuffers_[i].name();
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
        glClearNamedFramebufferfv(target, GL_COLOR, 0, nothing.data());
        glClearNamedFramebufferuiv(target, GL_COLOR, 1, nobody.data());
        glClearNamedFramebufferfv(target, GL_DEPTH, 0, &farthest);
        block.viewTiles = {1, 1, static_cast<int>(i), 1};
        scene_.bind(7, block);
        model.draw(1);
    }
    findPeaks();
}

void SceneSurfaces::findPeaks() {
    glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    bind();
    glBindImageTexture(0, peaks_.name(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_R32F);
    findPeaks_.use();
    constexpr int kGroup = 8; // as the shader's
    glDispatchCompute(static_cast<GLuint>((peaks_.width() + kGroup - 1) / kGroup),
                      static_cast<GLuint>((peaks_.height() + kGroup - 1) / kGroup),
                      static_cast<GLuint>(block_.lattice.w));
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void SceneSurfaces::bind() {
    uniforms_.bind(3, block_);
    glBindTextureUnit(0, disparities_.name());
    glBindTextureUnit(7, surfaces_.name());
    glBindTextureUnit(12, peaks_.name());
}

} // namespace autostereo::gpu

#pragma once

#include "calib/display_profile.hpp"
#include "gpu/atlas.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/gl/uniform_buffer.hpp"
#include "gpu/params.hpp"
#include "gpu/scene/scene_block.hpp"
#include "gpu/scene/scene_model.hpp"
#include "gpu/scene/scene_placement.hpp"

namespace autostereo::gpu {

/// A scene of triangles -> all views in the atlas, by the methods that draw triangles into every
/// view: multipass, instanced, geometry, mrt; the same picture to rounding.
/// Thread-bound.
class SceneViews {
  public:
    /// `synthesis.method`: anything but these four is drawn as instanced. Throws GlError.
    SceneViews(const calib::DisplayProfile& display, const SceneParams& scene,
               const SynthesisParams& synthesis, const std::array<double, 3>& clearColor);

    void render(const SceneModel& model, const SceneBlock& block, const Atlas& atlas);

    /// The method in use.
    [[nodiscard]] Method method() const { return method_; }

  private:
    void eachView(const SceneModel& model, SceneBlock block, const AtlasLayout& layout);
    void repeated(const SceneModel& model, SceneBlock block);
    void layered(const SceneModel& model, const SceneBlock& block, const Atlas& atlas);

    Method method_;
    std::array<double, 3> clearColor_;
    int viewsPerPass_ = 1; ///< geometry, mrt
    gl::Program program_;
    gl::Texture eyes_; ///< RGBA32F, a texel a view
    gl::UniformBuffer<SceneBlock> uniforms_;
    gl::Texture colors_, depths_; ///< mrt: a layer a view
    gl::Framebuffer framebuffer_;
};

/// Nearer surfaces hide farther ones while this lives.
class DepthTest {
  public:
    DepthTest() {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
    }
    ~DepthTest() { glDisable(GL_DEPTH_TEST); }
    DepthTest(const DepthTest&) = delete;
    DepthTest& operator=(const DepthTest&) = delete;
};

/// The defines that one kind of shading needs.
[[nodiscard]] std::vector<std::string> definesOf(SceneShading shading);
/// Eyes in display space as RGBA32F, one texel each.
[[nodiscard]] gl::Texture makeEyes(const std::vector<glm::dvec3>& eyes);
/// Where an eye of the fan stands in display space.
[[nodiscard]] glm::dvec3 fanEye(const calib::DisplayProfile& display, double b);
/// Where the display's views are seen from, left to right.
[[nodiscard]] std::vector<glm::dvec3> viewEyes(const calib::DisplayProfile& display);

} // namespace autostereo::gpu

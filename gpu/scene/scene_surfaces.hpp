#pragma once

#include "calib/display_profile.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/gl/uniform_buffer.hpp"
#include "gpu/scene/scene_block.hpp"
#include "gpu/scene/scene_model.hpp"
#include "gpu/scene/scene_placement.hpp"

#include <array>
#include <vector>

namespace autostereo::gpu {

/// shaders/scene_surfaces.glsl, binding 3.
struct SurfacesBlock {
    glm::ivec4 lattice{0};
    glm::vec4 lineup{0};
    glm::vec4 span{0};
    glm::vec4 backdrop{0};
};
static_assert(sizeof(SurfacesBlock) == 64);

/// What a few reference viewpoints of a scene see, as all other viewpoints can be made from it (the
/// super-multi-view paper, section II A): 32-bit disparity, normal, diffuse colour, and the number
/// of the part, which stands for specular colour, shininess and emission, as those do not vary
/// within one. The viewpoints are those of the sheared camera array (Eq. 1 and 2) from the
/// outermost view to the other, and look a margin past the panel's edges, so that their neighbours'
/// views lie within. Not for light at vertices, which cannot be put off. Thread-bound.
class SceneSurfaces {
  public:
    /// `references`: 2 to 5, at most as many as the display has views; each as large as `tile`, and
    /// the margins. Throws GlError.
    SceneSurfaces(const calib::DisplayProfile& display, const ScenePlacement& placement,
                  SceneShading shading, const calib::QuiltLayout& tile, int references,
                  const std::array<double, 3>& clearColor);

    void draw(const SceneModel& model, SceneBlock block);
    /// For shaders/scene_surfaces.glsl.
    void bind();

    [[nodiscard]] const SurfacesBlock& block() const { return block_; }
    /// R32F, a layer a reference: panel widths at |b| = 1; span.y where nothing is.
    [[nodiscard]] const gl::Texture& disparities() const { return disparities_; }
    /// RGBA32UI, likewise: part + 1 or 0, octahedral normal, diffuse as three halves.
    [[nodiscard]] const gl::Texture& surfaces() const { return surfaces_; }

  private:
    /// Texels of a row whose nearest disparity is known; as in shaders/scene_surfaces.glsl.
    static constexpr int kPeakBlock = 16;

    void findPeaks();

    gl::Program program_, findPeaks_;
    SurfacesBlock block_;
    gl::UniformBuffer<SurfacesBlock> uniforms_;
    gl::UniformBuffer<SceneBlock> scene_;
    gl::Texture eyes_, disparities_, surfaces_, peaks_, depth_;
    std::vector<gl::Framebuffer> framebuffers_; ///< one a reference
};

} // namespace autostereo::gpu

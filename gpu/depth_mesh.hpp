#pragma once

#include "calib/sensor_rig.hpp"
#include "gpu/blocks.hpp"
#include "gpu/gl/objects.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/gl/uniform_buffer.hpp"
#include "gpu/params.hpp"
#include "gpu/scene_geometry.hpp"

namespace autostereo::gpu {

/// A grid of triangles with everything that no view changes, ready to be drawn by any of them.
struct MeshLayer {
    gl::Texture points;  ///< RGBA32F per node: u, v, disparity at |b| = 1, z (m; 0: no node)
    gl::Texture sources; ///< RG32F per node: where the colour image sees it
    gl::Buffer indices;  ///< 6 per cell; cut triangles are degenerate
    GLsizei indexCount = 0;
};

/// Depth counts -> two mesh layers (after de Sorbier 2010, section II): the scene, cut where a
/// triangle would bridge two surfaces, and a coarse uncut background that shows where it was cut
/// or measured nothing. Work independent of the view happens here, once. Thread-bound.
class DepthMesh {
  public:
    /// Every so many depth pixels the background has a node.
    static constexpr int kBackgroundStride = 4;

    /// Throws GlError.
    DepthMesh(const DepthMeshParams& params, const calib::SensorRig& rig);

    /// `depth`: R16UI counts of `depthUnitM`. The textures follow its size.
    void build(const gl::Texture& depth, double depthUnitM, const SceneGeometry& geometry);

    [[nodiscard]] const MeshLayer& scene() const { return scene_; }
    [[nodiscard]] const MeshLayer& background() const { return background_; }
    /// What the last build used; drawing programs that need the cameras bind it too.
    [[nodiscard]] const MeshBlock& block() const { return block_; }

  private:
    void resize(int width, int height);
    void setBlock(double depthUnitM, const SceneGeometry& geometry);
    void buildSamples(const gl::Texture& depth);
    void buildLayer(const MeshLayer& layer, const gl::Texture& nodes, const gl::Program& points,
                    const gl::Program& indices);

    DepthMeshParams params_;
    calib::SensorRig rig_;
    MeshBlock block_;
    gl::UniformBuffer<MeshBlock> uniforms_;
    gl::Program reduce_, spread_;
    gl::Program scenePoints_, sceneIndices_;
    gl::Program backgroundPoints_, backgroundIndices_;
    gl::Texture rays_;              ///< RG32F: x/z, y/z of each depth pixel
    gl::Texture reduced_, samples_; ///< RGBA16UI: count, source pixel x, y
    MeshLayer scene_, background_;
};

} // namespace autostereo::gpu

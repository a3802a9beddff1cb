#pragma once

#include "calib/sensor_rig.hpp"
#include "gpu/blocks.hpp"
#include "gpu/color_visibility.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/gl/uniform_buffer.hpp"
#include "gpu/mesh_layer.hpp"
#include "gpu/params.hpp"
#include "gpu/scene_geometry.hpp"

namespace autostereo::gpu {

/// Depth counts -> two mesh layers (after de Sorbier 2010, section II): the scene, cut where a
/// triangle would bridge two surfaces, and a coarse uncut background that shows where it was cut
/// or measured nothing. What the colour
/// camera cannot see is no part of the scene. Work independent of the view happens here, once.
/// Thread-bound.
class DepthMesh {
  public:
    /// Every so many depth pixels the background has a node.
    static constexpr int kBackgroundStride = 4;

    /// Throws GlError.
    DepthMesh(const DepthMeshParams& params, const calib::SensorRig& rig);

    /// `depth`: R16UI counts of `depthUnitM`. The textures follow its size.
    void build(const gl::Texture& depth, double depthUnitM, const SceneGeometry& geometry);

    [[nodiscard]] const MeshLayers& layers() const { return layers_; }
    /// What the last build used; drawing programs that need the cameras bind it too.
    [[nodiscard]] const MeshBlock& block() const { return block_; }

  private:
    void resize(int width, int height);
    void setBlock(double depthUnitM, const SceneGeometry& geometry);
    void buildSamples(const gl::Texture& depth);
    static void buildIndices(const MeshLayer& layer, const gl::Texture& nodes,
                             const gl::Program& indices);

    DepthMeshParams params_;
    calib::SensorRig rig_;
    MeshBlock block_;
    gl::UniformBuffer<MeshBlock> uniforms_;
    ColorVisibility visibility_;
    gl::Program reduce_, spread_;
    gl::Program scenePoints_, sceneIndices_;
    gl::Program backgroundPoints_, backgroundIndices_;
    gl::Texture rays_;              ///< RG32F: x/z, y/z of each depth pixel
    gl::Texture reduced_, samples_; ///< RGBA16UI: count, source pixel x, y, measured
    MeshLayers layers_;
};

} // namespace autostereo::gpu

#pragma once

#include "calib/sensor_rig.hpp"
#include "gpu/blocks.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/gl/uniform_buffer.hpp"
#include "gpu/mesh_layer.hpp"
#include "gpu/mesh_redraw.hpp"
#include "gpu/params.hpp"
#include "gpu/scene_geometry.hpp"

#include <optional>

namespace autostereo::gpu {

/// Depth counts -> a mesh on the depth camera's grid (after de Sorbier 2010, section II), cut where
/// a triangle would bridge two surfaces. Thread-bound.
class DepthMesh {
  public:
    /// Throws GlError.
    DepthMesh(const DepthMeshParams& params, const calib::SensorRig& rig);

    /// `depth`: R16UI counts of `depthUnitM`. The textures follow its size. Leaves its block at
    /// binding 0. `changed`: blocks of `depth` that differ from the last one; none: all may.
    void build(const gl::Texture& depth, double depthUnitM, const SceneGeometry& geometry,
               const BlockMarks* changed = nullptr);

    [[nodiscard]] const MeshLayer& layer() const { return layer_; }
    /// What the last build changed.
    [[nodiscard]] const MeshRedraw& redraw() const { return redraw_; }
    /// What the last build used; drawing programs that need the cameras bind it too.
    [[nodiscard]] const MeshBlock& block() const { return block_; }

  private:
    void resize(int width, int height);
    void setBlock(double depthUnitM, const SceneGeometry& geometry);
    void buildIndices(const gl::Texture& depth);
    [[nodiscard]] bool isElsewhere(double depthUnitM, const SceneGeometry& geometry);

    DepthMeshParams params_;
    calib::SensorRig rig_;
    MeshBlock block_;
    gl::UniformBuffer<MeshBlock> uniforms_;
    gl::Program points_, indices_;
    gl::Texture rays_; ///< RG32F: x/z, y/z of each depth pixel
    MeshLayer layer_;
    BlockLister lister_;
    BlockList list_;
    MeshRedraw redraw_;
    std::optional<SceneGeometry> geometry_; ///< of the last build
    double depthUnitM_ = 0;
};

} // namespace autostereo::gpu

#pragma once

#include "calib/sensor_rig.hpp"
#include "gpu/blocks.hpp"
#include "gpu/fusion/background_layer.hpp"
#include "gpu/fusion/cyclopean_scene.hpp"
#include "gpu/fusion/hole_filler.hpp"
#include "gpu/layer_drawer.hpp"
#include "gpu/mesh_layer.hpp"
#include "gpu/params.hpp"
#include "gpu/scene_geometry.hpp"

namespace autostereo::gpu {

/// Measured mesh + colour -> the cyclopean scene and its background: the mesh is drawn once into
/// the cyclopean view, holes are filled, the hidden is continued.
/// After de Sorbier 2010, sections II.C and IV (the future work it names). Thread-bound.
class Fusion {
  public:
    Fusion(const PipelineParams& params, const calib::SensorRig& rig);

    /// `measured`: the depth grid's mesh (DepthMesh), whose MeshBlock is still at binding 0;
    /// `picture`: the colour camera's.
    void fuse(const MeshLayer& measured, const gl::Texture& picture, const SceneGeometry& geometry);
    /// `picture`: the one that was fused.
    [[nodiscard]] CyclopeanScene scene(const gl::Texture& picture) const {
        return {holes_.depth(), picture, background_.depth(), background_.color()};
    }
    [[nodiscard]] const gl::Texture& measuredDepth() const { return depth_; } ///< R32F, m; 0: none
    [[nodiscard]] const HoleFiller& holes() const { return holes_; }
    [[nodiscard]] const BackgroundLayer& background() const { return background_; }

  private:
    void resize(int columns, int rows);
    void drawCyclopean(const MeshLayer& measured);

    FusionParams params_;
    calib::SensorRig rig_;
    LayerDrawer drawer_;
    gl::Program cyclopean_;
    HoleFiller holes_;
    BackgroundLayer background_;
    gl::Texture depth_, depthTest_;
    gl::Framebuffer framebuffer_;
    calib::Framing framing_; ///< of what the background remembers
};

/// FusionParams in texels of the grid.
[[nodiscard]] FillBlock fillBlock(const FusionParams& params, const calib::SensorRig& rig,
                                  const SceneGeometry& geometry);

} // namespace autostereo::gpu

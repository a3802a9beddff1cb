#pragma once

#include "calib/sensor_rig.hpp"
#include "gpu/blocks.hpp"
#include "gpu/fusion/background_layer.hpp"
#include "gpu/fusion/cyclopean_scene.hpp"
#include "gpu/fusion/hole_filler.hpp"
#include "gpu/fusion/picture_marks.hpp"
#include "gpu/layer_drawer.hpp"
#include "gpu/mesh_layer.hpp"
#include "gpu/mesh_redraw.hpp"
#include "gpu/params.hpp"
#include "gpu/scene_geometry.hpp"

#include <optional>

namespace autostereo::gpu {

/// What differs from what was fused last.
struct FusionChanges {
    const MeshRedraw& mesh;
    const BlockMarks* picture; ///< blocks of the colour camera's picture; none: nowhere
};

/// Measured mesh + colour -> the cyclopean scene and its background: the mesh is drawn once into
/// the cyclopean view, holes are filled, the hidden is continued.
/// After de Sorbier 2010, sections II.C and IV (the future work it names). Thread-bound.
class Fusion {
  public:
    Fusion(const PipelineParams& params, const calib::SensorRig& rig);

    /// `measured`: the depth grid's mesh (DepthMesh), whose MeshBlock is still at binding 0;
    /// `picture`: the colour camera's.
    void fuse(const MeshLayer& measured, const gl::Texture& picture, const SceneGeometry& geometry,
              const FusionChanges* changes = nullptr);
    /// `picture`: the one that was fused.
    [[nodiscard]] CyclopeanScene scene(const gl::Texture& picture) const {
        return {holes_.depth(), picture, background_.depth(), background_.color(),
                everything_ ? nullptr : &changes_};
    }
    [[nodiscard]] const gl::Texture& measuredDepth() const { return depth_; } ///< R32F, m; 0: none
    [[nodiscard]] const HoleFiller& holes() const { return holes_; }
    [[nodiscard]] const BackgroundLayer& background() const { return background_; }

  private:
    void resize(int columns, int rows);
    void drawCyclopean(const MeshLayer& measured);
    void drawAgain(const MeshLayer& measured, const MeshRedraw& redraw);
    void findChanges(const SceneGeometry& geometry, const FusionChanges* changes);

    FusionParams params_;
    calib::SensorRig rig_;
    LayerDrawer drawer_;
    gl::Program cyclopean_, cleared_;
    HoleFiller holes_;
    BackgroundLayer background_;
    gl::Texture depth_, depthTest_;
    gl::Framebuffer framebuffer_;
    std::optional<SceneGeometry> geometry_; ///< of the last scene
    glm::ivec2 pictureSize_{0};
    bool everything_ = true; ///< is new in the last scene
    BlockLister lister_;
    BlockList redrawn_;
    BlockMarks nowhere_; ///< where everything is new nobody asks
    PictureMarks pictureMarks_;
    SceneChanges changes_;
};

/// FusionParams in texels of the grid.
[[nodiscard]] FillBlock fillBlock(const FusionParams& params, const calib::SensorRig& rig,
                                  const SceneGeometry& geometry);

} // namespace autostereo::gpu

#pragma once

#include "gpu/fusion/background_memory.hpp"
#include "gpu/fusion/cyclopean_scene.hpp"
#include "gpu/fusion/hole_filler.hpp"
#include "gpu/fusion/pull_push.hpp"
#include "gpu/params.hpp"

namespace autostereo::gpu {

/// What stands behind the scene: its own surfaces where nothing can be behind them, else the depth
/// of the surface across the edge and colours spread from around, never from what is nearer; or
/// what was seen there earlier; beyond the cut the backdrop. Only what changed is done again. Needs
/// MeshBlock at binding 0 and FillBlock at 3. Thread-bound.
class BackgroundLayer {
  public:
    explicit BackgroundLayer(const BackdropParams& backdrop);
    void resize(int columns, int rows);

    /// Marks `depth` and `color` of `scene` where they are others than last time. `unsure`: texels
    /// beside an edge whose colours may be mixed.
    void build(const HoleFiller& holes, const HoleFiller::Input& picture, int unsure,
               const SceneChanges& scene, BlockLister& lister, bool everything);
    [[nodiscard]] const gl::Texture& depth() const { return depth_; } ///< R32F, m, never 0
    [[nodiscard]] const gl::Texture& color() const { return color_; } ///< RGBA8
    [[nodiscard]] BackgroundMemory& memory() { return memory_; }
    [[nodiscard]] const BackgroundMemory& memory() const { return memory_; }
    [[nodiscard]] const gl::Texture& claims() const { return claims_; }

  private:
    void claim(const HoleFiller& holes, BlockLister& lister, bool everything);
    void spreadGuide(const HoleFiller& holes, BlockLister& lister, bool everything);
    void spreadColors(const HoleFiller& holes, const HoleFiller::Input& picture, int unsure,
                      BlockLister& lister, bool everything);
    void compose(const HoleFiller& holes, const HoleFiller::Input& picture,
                 const SceneChanges& scene, BlockLister& lister, bool everything);

    gl::Program claimRows_, guideSeeds_, colorSeeds_, compose_;
    BackgroundMemory memory_;
    PullPush guide_, colors_;
    gl::Texture claims_;  ///< RG32F: depth behind (m; 0: none), texels to the edge
    gl::Texture forward_; ///< the same half way
    BlockMarks claimMarks_;
    BlockList list_, bands_; ///< bands: of eight whole rows
    gl::Texture depth_, color_;
    gl::Texture backdrop_; ///< RGBA8, linear
};

} // namespace autostereo::gpu

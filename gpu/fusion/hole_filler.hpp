#pragma once

#include "gpu/blocks.hpp"
#include "gpu/dirty/block_lister.hpp"
#include "gpu/gl/counter_ring.hpp"

#include <optional>

namespace autostereo::gpu {

/// Measured depth on the cyclopean grid -> depth wherever the colour picture shows something: what
/// is too close to an edge to be sure is taken out, holes are filled from their row and column, and
/// at edges colours decide between the surfaces. Only what changed is done again.
/// Needs MeshBlock at binding 0. Thread-bound.
class HoleFiller {
  public:
    HoleFiller();
    void resize(int columns, int rows);

    /// A picture of the grid, and the blocks of it that differ from last time's.
    struct Input {
        const gl::Texture& texture;
        const BlockMarks& changed;
    };
    /// Leaves the block at binding 3. `color.changed`: blocks of the grid that show another colour.
    /// Marks `scene`, too, where the depth is another one. `everything`: all may have changed.
    void fill(const Input& measured, const Input& color, const FillBlock& block,
              const BlockMarks& scene, BlockLister& lister, bool everything);
    /// R32F, metres; 0: none.
    [[nodiscard]] const gl::Texture& depth() const { return filled_; }
    [[nodiscard]] const BlockMarks& depthChanged() const { return filledMarks_; }
    /// The same without what was filled.
    [[nodiscard]] const gl::Texture& sureDepth() const { return sure_; }
    [[nodiscard]] const BlockMarks& sureChanged() const { return sureMarks_; }

    /// Share of the grid whose depth was not looked at again, mean of the frames counted so far.
    [[nodiscard]] std::optional<double> keptShare() const;

  private:
    void takeCounts();
    void findSure(const Input& measured, int reach, BlockLister& lister, bool everything);

    gl::Program band_, fill_, unmark_;
    gl::UniformBuffer<FillBlock> uniforms_;
    gl::Texture sure_, filled_;
    BlockMarks sureMarks_, filledMarks_;
    BlockMarks unsure_; ///< blocks with any texel to fill, or just filled
    BlockList list_;
    gl::CounterRing counters_{1};
    std::uint64_t done_ = 0, frames_ = 0;
};

} // namespace autostereo::gpu

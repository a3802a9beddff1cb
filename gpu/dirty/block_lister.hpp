#pragma once

#include "gpu/blocks.hpp"
#include "gpu/dirty/block_list.hpp"
#include "gpu/gl/uniform_buffer.hpp"

#include <initializer_list>

namespace autostereo::gpu {

/// Fills BlockLists from marks: what a pass reads beyond its own texel is its reach. Thread-bound.
class BlockLister {
  public:
    /// Marks of a picture that a pass reads, and how far off its own place, texels of that
    /// picture across and down; with `cross` only in its own block's rows and columns.
    struct Source {
        const BlockMarks& marks;
        int reachX = 0, reachY = 0;
        bool cross = false;
        enum class Size { None, Same, Double, Half } size = Size::Same; ///< of that picture
    };
    static constexpr std::size_t kMostSources = 7;

    /// Throws GlError.
    BlockLister();
    /// Lists the blocks within reach of a mark of any source; of these, with `among`, the marked
    /// ones there.
    void list(BlockList& list, std::initializer_list<Source> sources,
              const BlockMarks* among = nullptr);

  private:
    gl::Program program_;
    gl::UniformBuffer<ListBlock> uniforms_;
};

} // namespace autostereo::gpu

#pragma once

#include "gpu/dirty/block_lister.hpp"
#include "gpu/mesh_layer.hpp"

namespace autostereo::gpu {

/// What of the depth mesh has to be drawn again when some of its nodes moved: the blocks of the
/// cyclopean grid that a triangle left or came to, and every triangle that reaches into one of
/// these, in the order of the whole mesh, so that a tie of two is decided alike. Needs MeshBlock at
/// binding 0. Thread-bound.
class MeshRedraw {
  public:
    /// Throws GlError.
    MeshRedraw();
    /// For a mesh of so many nodes.
    void resize(int columns, int rows);
    /// Makes place for the cyclopean grid; true where it is another one than before.
    bool fitGrid(int columns, int rows);

    /// Where nodes stood when the mesh was built last, RGBA32F; mesh_indices.comp renews it.
    [[nodiscard]] const gl::Texture& before() const { return before_; }
    /// After the nodes, before the indices: marks the footprint of cells whose nodes moved, in
    /// blocks of nodes that `cells` lists.
    void mark(const MeshLayer& mesh, const BlockList& cells) const;
    /// All of the grid.
    void markAll() const { footprint_.markAll(); }
    /// After the indices: takes down where the triangles of changed blocks (null: of all) are now,
    /// and picks those to draw.
    void pick(const MeshLayer& mesh, const BlockMarks* changed);

    [[nodiscard]] const BlockMarks& footprint() const { return footprint_; }
    /// Six for every cell picked, and how many (glDrawElementsIndirect).
    [[nodiscard]] const gl::Buffer& indices() const { return indices_; }
    [[nodiscard]] const gl::Buffer& command() const { return command_; }

  private:
    gl::Program mark_, bound_, list_, pick_;
    gl::Texture before_;
    gl::Texture bounds_; ///< RGBA16UI, a texel a block of cells: first and last block of the grid
    gl::Texture everywhere_;
    BlockMarks footprint_;
    BlockList picked_;
    gl::Buffer indices_, command_;
};

} // namespace autostereo::gpu

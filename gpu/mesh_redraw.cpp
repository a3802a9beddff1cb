#include "gpu/mesh_redraw.hpp"

#include <array>

namespace autostereo::gpu {

MeshRedraw::MeshRedraw()
    : mark_({"mesh_footprint.comp"}), bound_({"mesh_bounds.comp"}),
      list_({"mesh_pick.comp"}, {"LIST"}), pick_({"mesh_pick.comp"}), everywhere_(GL_R8UI, 1, 1) {
    const std::uint8_t mark = 1;
    glClearTexImage(everywhere_.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_BYTE, &mark);
    constexpr std::array<GLuint, 5> kNothing{0, 1, 0, 0, 0};
    command_ = gl::makeBuffer(sizeof kNothing, kNothing.data(), 0);
}

void MeshRedraw::resize(int columns, int rows) {
    before_ = gl::Texture(GL_RGBA32F, columns, rows);
    picked_.resize(columns, rows);
    bounds_ = gl::Texture(GL_RGBA16UI, picked_.across(), picked_.down());
    indices_ =
        makeMeshLayer(1, 1, MeshLayer::kBlockCells * picked_.across() * picked_.down()).indices;
}

bool MeshRedraw::fitGrid(int columns, int rows) {
    const gl::Texture& marks = footprint_.texture();
    if (marks.isSized(BlockMarks::blocksOf(columns), BlockMarks::blocksOf(rows))) return false;
    footprint_.resize(columns, rows);
    return true;
}

void MeshRedraw::mark(const MeshLayer& mesh, const BlockList& cells) const {
    footprint_.clear();
    glBindTextureUnit(0, mesh.points.name());
    glBindTextureUnit(1, before_.name());
    footprint_.bind(0);
    cells.dispatch(mark_);
}

void MeshRedraw::pick(const MeshLayer& mesh, const BlockMarks* changed) {
    constexpr int kPerGroup = 64;
    glBindTextureUnit(0, mesh.points.name());
    glBindTextureUnit(1, (changed != nullptr ? changed->texture() : everywhere_).name());
    glBindImageTexture(0, bounds_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16UI);
    bound_.use();
    const int blocks = picked_.across() * picked_.down();
    glDispatchCompute(static_cast<GLuint>((blocks + kPerGroup - 1) / kPerGroup), 1, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);

    glBindTextureUnit(0, bounds_.name());
    glBindTextureUnit(1, footprint_.texture().name());
    picked_.beginFinding();
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 7, command_.name());
    list_.use();
    glDispatchCompute(1, 1, 1);

    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, mesh.indices.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, indices_.name());
    picked_.dispatch(pick_);
    glMemoryBarrier(GL_ELEMENT_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

} // namespace autostereo::gpu

#include "gpu/interleaver.hpp"

#include <string>
#include <vector>

namespace autostereo::gpu {

Interleaver::Interleaver(const calib::ViewMap& map, TileFilter filter)
    : width_(static_cast<int>(map.columns.size() / 3)), height_(static_cast<int>(map.rows.size())),
      program_({"full_screen.vert", "interleaver.frag"}, filter == TileFilter::Nearest
                                                             ? std::vector<std::string>{"NEAREST"}
                                                             : std::vector<std::string>{}),
      columnPhases_(GL_RGBA32UI, width_, 1), rowPhases_(GL_R32UI, height_, 1),
      vertexArray_(gl::makeVertexArray()) {
    glTextureSubImage2D(columnPhases_.name(), 0, 0, 0, width_, 1, GL_RGB_INTEGER, GL_UNSIGNED_INT,
                        map.columns.data());
    glTextureSubImage2D(rowPhases_.name(), 0, 0, 0, height_, 1, GL_RED_INTEGER, GL_UNSIGNED_INT,
                        map.rows.data());
    block_.fan = {map.views, map.reversed ? 1U : 0U, 0U, 0U};
    block_.panel = {width_, height_, 0, 0};
}

void Interleaver::render(const Atlas& atlas, GLuint framebuffer) {
    const calib::QuiltLayout& quilt = atlas.layout().quilt;
    block_.tiles = {quilt.columns, quilt.tileWidth, quilt.tileHeight, 0};
    uniforms_.bind(2, block_);
    program_.use();
    glBindTextureUnit(0, atlas.color().name());
    glBindTextureUnit(1, columnPhases_.name());
    glBindTextureUnit(2, rowPhases_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width_, height_);
    glBindVertexArray(vertexArray_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace autostereo::gpu

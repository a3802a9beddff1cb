#include "gpu/panel_pass.hpp"

#include <array>

namespace autostereo::gpu {

PanelPass::PanelPass(const std::string& fragmentShader, const std::vector<std::string>& defines,
                     int width, int height, Cover cover)
    : width_(width), height_(height), cover_(cover),
      program_({cover == Cover::Panel ? "full_screen.vert" : "stale_tiles.vert", fragmentShader},
               defines),
      vertexArray_(gl::makeVertexArray()) {
    block_.panel = {width_, height_, 1, 1};
    block_.fine = {1.0F / static_cast<float>(width_), 1.0F / static_cast<float>(height_), 0.0F,
                   0.0F};
}

void PanelPass::draw(const Atlas* atlas, GLuint framebuffer) {
    if (atlas != nullptr) useTiles(*atlas);
    bindBlock();
    program_.use();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width_, height_);
    glBindVertexArray(vertexArray_.name());
    if (cover_ == Cover::Panel)
        glDrawArrays(GL_TRIANGLES, 0, 3);
    else
        glDrawArraysIndirect(GL_TRIANGLE_STRIP, nullptr);
}

void PanelPass::setSearch(const SearchParams& params) {
    constexpr double kCycle = 4294967296.0; // 2^32
    block_.fine.z = static_cast<float>(params.channelStep);
    block_.rig = {params.firstPosition, params.positionPerCycle / kCycle, 0, 0};
}

void PanelPass::useTiles(const Atlas& atlas) {
    const calib::QuiltLayout& quilt = atlas.layout().quilt;
    block_.tiles = {quilt.columns, quilt.tileWidth, quilt.tileHeight, 0};
    block_.scale = {static_cast<float>(quilt.tileWidth) / static_cast<float>(width_),
                    static_cast<float>(quilt.tileHeight) / static_cast<float>(height_), 0.0F, 0.0F};
    const auto columns = static_cast<std::uint32_t>(quilt.columns);
    block_.atlasRow.x = ((1U << 20) + columns - 1) / columns;
    glBindTextureUnit(0, atlas.color().name());
}

gl::Texture tableTexture(int channels, int width, int height, const std::uint32_t* numbers) {
    struct Format {
        GLenum stored, given;
    };
    constexpr std::array<Format, 3> kFormats{
        {{GL_R32UI, GL_RED_INTEGER}, {GL_RG32UI, GL_RG_INTEGER}, {GL_RGBA32UI, GL_RGB_INTEGER}}};
    const Format format = kFormats.at(static_cast<std::size_t>(channels - 1));
    gl::Texture texture(format.stored, width, height);
    glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, format.given, GL_UNSIGNED_INT,
                        numbers);
    return texture;
}

} // namespace autostereo::gpu

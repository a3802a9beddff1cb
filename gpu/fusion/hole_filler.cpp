#include "gpu/fusion/hole_filler.hpp"

#include "gpu/gl/dispatch.hpp"

namespace autostereo::gpu {

HoleFiller::HoleFiller() : band_({"edge_band.comp"}), fill_({"fill_holes.comp"}) {}

void HoleFiller::resize(int columns, int rows) {
    sure_ = gl::Texture(GL_R32F, columns, rows);
    filled_ = gl::Texture(GL_R32F, columns, rows);
}

void HoleFiller::fill(const gl::Texture& measured, const gl::Texture& color,
                      const FillBlock& block) {
    uniforms_.bind(3, block);
    glBindTextureUnit(0, measured.name());
    glBindImageTexture(0, sure_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
    gl::dispatch(band_, sure_.width(), sure_.height());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);

    glBindTextureUnit(0, sure_.name());
    glBindTextureUnit(1, color.name());
    glBindTextureUnit(2, measured.name());
    glBindImageTexture(0, filled_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
    gl::dispatch(fill_, filled_.width(), filled_.height());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

} // namespace autostereo::gpu

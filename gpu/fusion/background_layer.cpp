#include "gpu/fusion/background_layer.hpp"

#include "gpu/gl/dispatch.hpp"

namespace autostereo::gpu {

namespace {

/// What is hidden belongs to the next edge, however small; colours are taken from four texels
/// around where there are any, else from a wide mean.
constexpr std::size_t kAllLevels = 32, kNarrowLevels = 2;

void waitForTexels() {
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

} // namespace

BackgroundLayer::BackgroundLayer(const BackdropParams& backdrop)
    : claimRows_({"background_claims.comp"}), guideSeeds_({"background_guide.comp"}),
      colorSeeds_({"background_seeds.comp"}), compose_({"background_compose.comp"}),
      guide_(kAllLevels), colors_(kNarrowLevels),
      backdrop_(GL_RGBA8, backdrop.width, backdrop.height) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(backdrop_.name(), 0, 0, 0, backdrop.width, backdrop.height, GL_RGBA,
                        GL_UNSIGNED_BYTE, backdrop.pixels.data());
    backdrop_.setFilter(GL_LINEAR);
}

void BackgroundLayer::resize(int columns, int rows) {
    memory_.resize(columns, rows);
    guide_.resize(columns, rows);
    colors_.resize(columns, rows);
    claims_ = gl::Texture(GL_RG32F, columns, rows);
    depth_ = gl::Texture(GL_R32F, columns, rows);
    color_ = gl::Texture(GL_RGBA8, columns, rows);
    color_.setFilter(GL_LINEAR);
}

void BackgroundLayer::build(const gl::Texture& measured, const gl::Texture& filled,
                            const gl::Texture& picture) {
    claim(filled);
    spreadGuide();
    glBindTextureUnit(5, memory_.depth().name());
    glBindTextureUnit(6, memory_.color().name());
    spreadColors(measured, filled, picture);
    compose(filled, picture);
}

void BackgroundLayer::claim(const gl::Texture& filled) {
    constexpr int kRowsPerGroup = 64;
    glBindTextureUnit(0, filled.name());
    glBindImageTexture(0, claims_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RG32F);
    claimRows_.use();
    glDispatchCompute(static_cast<GLuint>((claims_.height() + kRowsPerGroup - 1) / kRowsPerGroup),
                      1, 1);
    waitForTexels();
}

void BackgroundLayer::spreadGuide() {
    const gl::Texture& seeds = guide_.seeds();
    glBindTextureUnit(0, claims_.name());
    glBindImageTexture(0, seeds.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    gl::dispatch(guideSeeds_, seeds.width(), seeds.height());
    waitForTexels();
    guide_.spread();
}

void BackgroundLayer::spreadColors(const gl::Texture& measured, const gl::Texture& filled,
                                   const gl::Texture& picture) {
    const gl::Texture& seeds = colors_.seeds();
    glBindTextureUnit(0, measured.name());
    glBindTextureUnit(1, claims_.name());
    glBindTextureUnit(2, guide_.seeds().name());
    glBindTextureUnit(3, picture.name());
    glBindTextureUnit(4, filled.name());
    glBindTextureUnit(7, guide_.mean().name());
    glBindImageTexture(0, seeds.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    gl::dispatch(colorSeeds_, seeds.width(), seeds.height());
    waitForTexels();
    colors_.spread();
}

void BackgroundLayer::compose(const gl::Texture& filled, const gl::Texture& picture) {
    glBindTextureUnit(0, filled.name());
    glBindTextureUnit(1, claims_.name());
    glBindTextureUnit(2, guide_.seeds().name());
    glBindTextureUnit(3, picture.name());
    glBindTextureUnit(4, colors_.seeds().name());
    glBindTextureUnit(7, backdrop_.name());
    glBindImageTexture(0, depth_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
    glBindImageTexture(1, color_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
    gl::dispatch(compose_, depth_.width(), depth_.height());
    waitForTexels();
}

} // namespace autostereo::gpu

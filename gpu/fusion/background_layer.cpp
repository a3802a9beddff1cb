#include "gpu/fusion/background_layer.hpp"

#include <algorithm>

namespace autostereo::gpu {

namespace {

/// What is hidden belongs to the next edge, however small; colours are taken from four texels
/// around where there are any, else from a wide mean.
constexpr std::size_t kAllLevels = 32, kNarrowLevels = 2;

} // namespace

BackgroundLayer::BackgroundLayer(const BackdropParams& backdrop)
    : claimRows_({"background_claims.comp"}), guideSeeds_({"background_guide.comp"}),
      colorSeeds_({"background_seeds.comp"}), compose_({"background_compose.comp"}),
      guide_(kAllLevels, PullPush::Kind::Guide), colors_(kNarrowLevels, PullPush::Kind::Hidden),
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
    forward_ = gl::Texture(GL_RG32F, columns, rows);
    claimMarks_.resize(columns, rows);
    list_.resize(columns, rows);
    bands_.resize(1, rows);
    depth_ = gl::Texture(GL_R32F, columns, rows);
    color_ = gl::Texture(GL_RGBA8, columns, rows);
    color_.setFilter(GL_LINEAR);
}

void BackgroundLayer::build(const HoleFiller& holes, const HoleFiller::Input& picture, int unsure,
                            const SceneChanges& scene, BlockLister& lister, bool everything) {
    claim(holes, lister, everything);
    spreadGuide(holes, lister, everything);
    spreadColors(holes, picture, unsure, lister, everything);
    compose(holes, picture, scene, lister, everything);
}

void BackgroundLayer::claim(const HoleFiller& holes, BlockLister& lister, bool everything) {
    if (everything)
        bands_.listAll();
    else
        lister.list(bands_, {{holes.depthChanged(), claims_.width()}});
    claimMarks_.clear();
    glBindTextureUnit(0, holes.depth().name());
    glBindImageTexture(0, claims_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RG32F);
    glBindImageTexture(1, forward_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RG32F);
    claimMarks_.bind(2);
    bands_.dispatch(claimRows_);
}

void BackgroundLayer::spreadGuide(const HoleFiller& holes, BlockLister& lister, bool everything) {
    if (everything)
        list_.listAll();
    else
        lister.list(list_, {{claimMarks_}});
    guide_.seedMarks().clear();
    glBindTextureUnit(0, claims_.name());
    glBindImageTexture(0, guide_.seeds().name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    guide_.seedMarks().bind(1);
    list_.dispatch(guideSeeds_);
    guide_.spread(holes.depth(), claims_, lister, everything);
}

void BackgroundLayer::spreadColors(const HoleFiller& holes, const HoleFiller::Input& picture,
                                   int unsure, BlockLister& lister, bool everything) {
    const int wide = std::max(claims_.width(), claims_.height());
    if (everything)
        list_.listAll();
    else
        lister.list(list_, {{holes.sureChanged()},
                            {holes.depthChanged(), unsure, unsure},
                            {claimMarks_},
                            {guide_.changed()},
                            {picture.changed},
                            {memory_.changed()},
                            {guide_.meanChanged(), wide, wide}});
    colors_.seedMarks().clear();
    glBindTextureUnit(0, holes.sureDepth().name());
    glBindTextureUnit(1, claims_.name());
    glBindTextureUnit(2, guide_.values().name());
    glBindTextureUnit(3, picture.texture.name());
    glBindTextureUnit(4, holes.depth().name());
    glBindTextureUnit(5, memory_.depth().name());
    glBindTextureUnit(6, memory_.color().name());
    glBindTextureUnit(7, guide_.mean().name());
    glBindImageTexture(0, colors_.seeds().name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    colors_.seedMarks().bind(1);
    list_.dispatch(colorSeeds_);
    colors_.spread(holes.depth(), claims_, lister, everything);
}

void BackgroundLayer::compose(const HoleFiller& holes, const HoleFiller::Input& picture,
                              const SceneChanges& scene, BlockLister& lister, bool everything) {
    if (everything)
        list_.listAll();
    else
        lister.list(list_, {{holes.depthChanged()},
                            {claimMarks_},
                            {guide_.changed()},
                            {picture.changed},
                            {memory_.changed()},
                            {colors_.changed()}});
    glBindTextureUnit(0, holes.depth().name());
    glBindTextureUnit(1, claims_.name());
    glBindTextureUnit(2, guide_.values().name());
    glBindTextureUnit(3, picture.texture.name());
    glBindTextureUnit(4, colors_.values().name());
    glBindTextureUnit(5, memory_.depth().name());
    glBindTextureUnit(6, memory_.color().name());
    glBindTextureUnit(7, backdrop_.name());
    glBindImageTexture(0, depth_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32F);
    glBindImageTexture(1, color_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA8);
    scene.depth.bind(2);
    scene.color.bind(3);
    list_.dispatch(compose_);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

} // namespace autostereo::gpu

#include "gpu/fusion/hole_filler.hpp"

namespace autostereo::gpu {

HoleFiller::HoleFiller()
    : band_({"edge_band.comp"}), fill_({"fill_holes.comp"}), unmark_({"unmark_blocks.comp"}) {}

void HoleFiller::resize(int columns, int rows) {
    sure_ = gl::Texture(GL_R32F, columns, rows);
    filled_ = gl::Texture(GL_R32F, columns, rows);
    sureMarks_.resize(columns, rows);
    filledMarks_.resize(columns, rows);
    unsure_.resize(columns, rows);
    list_.resize(columns, rows);
    counters_.forget(); // they counted other blocks
    done_ = frames_ = 0;
}

void HoleFiller::findSure(const Input& measured, int reach, BlockLister& lister, bool everything) {
    if (everything)
        list_.listAll();
    else
        lister.list(list_, {{measured.changed, reach, reach}});
    sureMarks_.clear();
    unsure_.bind(0);
    counters_.begin(1);
    list_.dispatch(unmark_);
    counters_.end();
    glBindTextureUnit(0, measured.texture.name());
    glBindImageTexture(0, sure_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32F);
    sureMarks_.bind(1);
    unsure_.bind(2);
    list_.dispatch(band_);
}

void HoleFiller::fill(const Input& measured, const Input& color, const FillBlock& block,
                      const BlockMarks& scene, BlockLister& lister, bool everything) {
    takeCounts();
    uniforms_.bind(3, block);
    findSure(measured, block.reach.w, lister, everything);
    const int far = block.reach.x, near = block.reach.y;
    if (everything)
        list_.listAll();
    else
        lister.list(list_,
                    {{sureMarks_, far, far, true},
                     {measured.changed, near, near},
                     {color.changed, near, near}},
                    &unsure_);
    filledMarks_.clear();
    glBindTextureUnit(0, sure_.name());
    glBindTextureUnit(1, color.texture.name());
    glBindTextureUnit(2, measured.texture.name());
    glBindImageTexture(0, filled_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32F);
    filledMarks_.bind(1);
    scene.bind(2);
    list_.dispatch(fill_);
}

void HoleFiller::takeCounts() {
    while (const auto counts = counters_.take()) {
        done_ += counts->front();
        ++frames_;
    }
}

std::optional<double> HoleFiller::keptShare() const {
    if (frames_ == 0) return std::nullopt;
    const double blocks = static_cast<double>(list_.across()) * list_.down();
    return 1 - static_cast<double>(done_) / (blocks * static_cast<double>(frames_));
}

} // namespace autostereo::gpu

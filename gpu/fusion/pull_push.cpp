#include "gpu/fusion/pull_push.hpp"

namespace autostereo::gpu {

namespace {

constexpr int kFewBlocks = 64; // quicker done than listed

bool isSmall(const BlockList& list) { return list.across() * list.down() <= kFewBlocks; }

std::vector<std::string> finishVariant(PullPush::Kind kind) {
    if (kind == PullPush::Kind::Hidden) return {"COARSEST"};
    return {"COARSEST", "HELD"};
}

} // namespace

PullPush::PullPush(std::size_t sharpLevels, Kind kind)
    : sharpLevels_(sharpLevels), pull_({"pull.comp"}), pullSharp_({"pull.comp"}, {"SHARP"}),
      push_({"push.comp"}), pushFinest_({"push.comp"}, {kind == Kind::Guide ? "GUIDE" : "HIDDEN"}),
      finish_({"push.comp"}, finishVariant(kind)) {}

void PullPush::resize(int width, int height) {
    pulled_.clear();
    pushed_.clear();
    lists_.clear();
    while (true) {
        for (auto* levels : {&pulled_, &pushed_}) {
            Level& level = levels->emplace_back();
            level.texture = gl::Texture(GL_RGBA32F, width, height);
            level.marks.resize(width, height);
        }
        pushed_.back().texture.setFilter(GL_LINEAR);
        lists_.emplace_back().resize(width, height);
        if (width == 1 && height == 1) return;
        width = (width + 1) / 2;
        height = (height + 1) / 2;
    }
}

void PullPush::pull(std::size_t level, BlockLister& lister, bool everything) {
    BlockList& list = lists_[level];
    const Level &fine = pulled_[level - 1], &coarse = pulled_[level];
    if (everything || isSmall(list))
        list.listAll();
    else
        lister.list(list, {{.marks = fine.marks, .size = BlockLister::Source::Size::Double}});
    coarse.marks.clear();
    glBindTextureUnit(0, fine.texture.name());
    glBindImageTexture(0, coarse.texture.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    coarse.marks.bind(1);
    list.dispatch(level <= sharpLevels_ ? pullSharp_ : pull_);
}

void PullPush::push(std::size_t level, const gl::Texture& filled, const gl::Texture& claims,
                    BlockLister& lister, bool everything) {
    BlockList& list = lists_[level];
    const Level &own = pulled_[level], &all = pushed_[level];
    const bool isCoarsest = level + 1 == pushed_.size();
    const Level& coarse = pushed_[isCoarsest ? level : level + 1];
    if (everything || isSmall(list))
        list.listAll();
    else
        lister.list(list, {{.marks = own.marks},
                           {.marks = coarse.marks, .size = BlockLister::Source::Size::Half}});
    all.marks.clear();
    if (!isCoarsest) glBindTextureUnit(0, coarse.texture.name());
    glBindTextureUnit(1, own.texture.name());
    glBindTextureUnit(2, filled.name());
    glBindTextureUnit(3, claims.name());
    glBindImageTexture(0, all.texture.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    all.marks.bind(1);
    list.dispatch(isCoarsest ? finish_ : level == 0 ? pushFinest_ : push_);
}

void PullPush::spread(const gl::Texture& filled, const gl::Texture& claims, BlockLister& lister,
                      bool everything) {
    for (std::size_t level = 1; level < pulled_.size(); ++level)
        pull(level, lister, everything);
    for (std::size_t level = pushed_.size(); level > 0; --level)
        push(level - 1, filled, claims, lister, everything);
}

} // namespace autostereo::gpu

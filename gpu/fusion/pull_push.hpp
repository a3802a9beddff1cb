#pragma once

#include "gpu/dirty/block_lister.hpp"

#include <cstddef>
#include <vector>

namespace autostereo::gpu {

/// Spreads sparse weighted values over a whole picture: each empty place takes what lies around it,
/// from a pyramid of weighted means (pull) whose finer levels keep what they have (push); after
/// Gortler et al. 1996, section 3.4. On the first levels few seeds are enough to keep to them, on
/// the others what lies farther off is mixed in. Only what changed is done again. Thread-bound.
class PullPush {
  public:
    /// What is spread: depth that guides colours, whose mean stays while it is about right (2 %),
    /// or colours of what is hidden.
    enum class Kind { Guide, Hidden };
    PullPush(std::size_t sharpLevels, Kind kind);
    void resize(int width, int height);

    /// Level 0: write values times weight, and the weight (0..1) in alpha, RGBA32F; mark what is
    /// another seed than before.
    [[nodiscard]] const gl::Texture& seeds() const { return pulled_.front().texture; }
    [[nodiscard]] const BlockMarks& seedMarks() const { return pulled_.front().marks; }
    /// `filled` and `claims`: of BackgroundLayer.
    void spread(const gl::Texture& filled, const gl::Texture& claims, BlockLister& lister,
                bool everything);
    /// Values, alpha 1 (0 where no seed is anywhere); where another than before, and it matters.
    [[nodiscard]] const gl::Texture& values() const { return pushed_.front().texture; }
    [[nodiscard]] const BlockMarks& changed() const { return pushed_.front().marks; }
    /// One texel: the mean of what was spread; whether another than before.
    [[nodiscard]] const gl::Texture& mean() const { return pushed_.back().texture; }
    [[nodiscard]] const BlockMarks& meanChanged() const { return pushed_.back().marks; }

  private:
    struct Level {
        gl::Texture texture;
        BlockMarks marks;
    };
    void pull(std::size_t level, BlockLister& lister, bool everything);
    void push(std::size_t level, const gl::Texture& filled, const gl::Texture& claims,
              BlockLister& lister, bool everything);

    std::size_t sharpLevels_;
    gl::Program pull_, pullSharp_, push_, pushFinest_, finish_;
    std::vector<Level> pulled_, pushed_;
    std::vector<BlockList> lists_;
};

} // namespace autostereo::gpu

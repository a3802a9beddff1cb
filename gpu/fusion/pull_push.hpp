#pragma once

#include "gpu/gl/program.hpp"

#include <cstddef>
#include <vector>

namespace autostereo::gpu {

/// Spreads sparse weighted values over a whole picture: each empty place takes what lies around it,
/// from a pyramid of weighted means (pull) whose finer levels keep what they have (push); after
/// Gortler et al. 1996, section 3.4. On the first levels few seeds are enough to keep to them, on
/// the others what lies farther off is mixed in. Thread-bound.
class PullPush {
  public:
    explicit PullPush(std::size_t sharpLevels);
    void resize(int width, int height);

    /// Level 0: write values times weight, and the weight (0..1) in alpha, RGBA32F.
    [[nodiscard]] const gl::Texture& seeds() const { return levels_.front(); }
    /// Turns the seeds into the result: values, alpha 1 (0 where no seed is anywhere). In place.
    void spread() const;
    /// One texel: the mean of what was spread.
    [[nodiscard]] const gl::Texture& mean() const { return levels_.back(); }

  private:
    std::size_t sharpLevels_;
    gl::Program pull_, pullSharp_, push_, finish_;
    std::vector<gl::Texture> levels_;
};

} // namespace autostereo::gpu

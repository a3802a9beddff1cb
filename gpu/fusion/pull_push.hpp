#pragma once

#include "gpu/gl/program.hpp"

#include <vector>

namespace autostereo::gpu {

/// Spreads sparse weighted values over a whole picture: each empty place takes what lies around it,
/// from a pyramid of weighted means (pull) whose finer levels keep what they have (push); after
/// Gortler et al. 1996, section 3.4. Thread-bound.
class PullPush {
  public:
    PullPush();
    void resize(int width, int height);

    /// Level 0: write values times weight, and the weight (0..1) in alpha, RGBA32F.
    [[nodiscard]] const gl::Texture& seeds() const { return levels_.front(); }
    /// Turns the seeds into the result: values, alpha 1 (0 where no seed is anywhere). In place.
    void spread() const;

  private:
    gl::Program pull_, push_, finish_;
    std::vector<gl::Texture> levels_;
};

} // namespace autostereo::gpu

#pragma once

#include "calib/phase_tables.hpp"
#include "gpu/gl/objects.hpp"

namespace autostereo::gpu {

/// A phase grid as the textures of shaders/grid_phase.glsl. Without nodes it holds nothing.
/// Thread-bound.
class PhaseGrid {
  public:
    explicit PhaseGrid(const calib::GridTables& tables);
    void bind() const;

  private:
    gl::Texture nodes_, columns_, rows_;
};

} // namespace autostereo::gpu

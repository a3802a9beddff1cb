#pragma once

#include "calib/view_map.hpp"
#include "gpu/interleaver.hpp"
#include "gpu/panel_pass.hpp"
#include "gpu/phase_grid.hpp"

namespace autostereo::gpu {

/// Every sub-pixel reads its channel from its view's tile. Which view is decided in fixed point,
/// bit for bit as ViewMap does on the host.
class ViewInterleaver final : public Interleaver {
  public:
    ViewInterleaver(const calib::ViewMap& map, const InterleaverParams& params);
    void render(const DrawnViews& views, GLuint framebuffer) override;

  private:
    PanelPass pass_;
    gl::UniformBuffer<PhaseBlock<1>> uniforms_;
    PhaseBlock<1> phase_;
    gl::Texture phaseTable_; ///< LUT or pattern
    PhaseGrid grid_;
    gl::Texture remap_;
};

} // namespace autostereo::gpu

#pragma once

#include "gpu/interleaver.hpp"
#include "gpu/panel_pass.hpp"

namespace autostereo::gpu {

/// Picture and disparity side by side with the display's header (calib/depth_frame_header.hpp).
/// Needs DrawnViews::disparity.
class DepthFramePacker final : public Interleaver {
  public:
    DepthFramePacker(const calib::DepthFrame& frame, int width, int height);
    void render(const DrawnViews& views, GLuint framebuffer) override;

  private:
    PanelPass pass_;
    gl::Texture header_;
};

} // namespace autostereo::gpu

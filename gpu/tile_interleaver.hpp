#pragma once

#include "gpu/interleaver.hpp"
#include "gpu/panel_pass.hpp"

namespace autostereo::gpu {

/// Whole views in tiles of the panel: side by side, top and bottom, quilts.
class TileInterleaver final : public Interleaver {
  public:
    TileInterleaver(const calib::TileFrame& frame, int width, int height,
                    const InterleaverParams& params);
    void render(const DrawnViews& views, GLuint framebuffer) override;

  private:
    PanelPass pass_;
};

} // namespace autostereo::gpu

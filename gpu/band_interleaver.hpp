#pragma once

#include "calib/band_map.hpp"
#include "gpu/interleaver.hpp"
#include "gpu/panel_pass.hpp"
#include "gpu/phase_grid.hpp"

namespace autostereo::gpu {

/// Every sub-pixel shows the views of those eyes that see it through the barrier: the maximum where
/// bands overlap (Kooima 2007, section 3.5), with a waveform the maximum less the negative lobes.
class BandInterleaver final : public Interleaver {
  public:
    BandInterleaver(const calib::BandMap& map, const InterleaverParams& params);
    void render(const DrawnViews& views, GLuint framebuffer) override;
    /// New eyes, as many as before. Between frames.
    void update(const calib::BandMap& map);

  private:
    PanelPass pass_;
    static constexpr std::size_t kMostEyes = 16;
    gl::UniformBuffer<PhaseBlock<kMostEyes>> uniforms_;
    PhaseBlock<kMostEyes> phases_;
    PhaseGrid grid_;
    gl::Texture edges_; ///< of a waveform: RGBA32F, one texel a channel
};

} // namespace autostereo::gpu

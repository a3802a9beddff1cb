#pragma once

#include "gpu/atlas.hpp"
#include "gpu/band_interleaver.hpp"
#include "gpu/blocks.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/layer_drawer.hpp"
#include "gpu/views/layer_mesher.hpp"
#include "gpu/views/view_synthesis.hpp"

#include <array>

namespace autostereo::gpu {

/// Two eyes that move, wherever they are: a raster view each, off-axis from the eye itself, then
/// the Combiner (Kooima 2007, section 3): each view in the bands of the barrier or lenses that only
/// its eye sees, black guard bands between them. Eyes latched by `setEyes` count from the next
/// `show` on, which costs two draws of the prepared layers and one pass over the panel.
class EyeSynthesis final : public ViewSynthesis {
  public:
    /// Displays that follow two eyes.
    [[nodiscard]] static bool fits(const calib::DisplayProfile& display);

    /// At first the display's nominal eyes. Throws GlError.
    EyeSynthesis(const PipelineParams& params, const calib::DisplayProfile& display, int panelWidth,
                 int panelHeight);
    void prepare(const CyclopeanScene& scene) override;
    void show(const CyclopeanScene& scene, GLuint panel) override;
    void setEyes(const calib::EyePair& eyes) override;
    [[nodiscard]] const Atlas* atlas() const override { return &atlas_; }

  private:
    void drawViews(const CyclopeanScene& scene);

    PipelineParams params_;
    calib::DisplayProfile display_;
    int panelWidth_, panelHeight_;
    calib::EyePair eyes_;
    Atlas atlas_;
    LayerMesher mesher_;
    const MeshLayers* layers_ = nullptr; ///< the mesher's, once prepared
    LayerDrawer drawer_;
    gl::Program program_;
    gl::UniformBuffer<EyeBlock> uniforms_;
    BandInterleaver interleaver_;
};

} // namespace autostereo::gpu

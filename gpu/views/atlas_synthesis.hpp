#pragma once

#include "gpu/interleaver.hpp"
#include "gpu/views/atlas_views.hpp"
#include "gpu/views/disparity_view.hpp"
#include "gpu/views/layer_mesher.hpp"
#include "gpu/views/view_synthesis.hpp"

#include <optional>

namespace autostereo::gpu {

/// Every view drawn into its tile, then interleaved (de Sorbier 2008, 2010; Kooima 2007).
class AtlasSynthesis final : public ViewSynthesis {
  public:
    /// Throws GlError.
    AtlasSynthesis(const PipelineParams& params, const calib::DisplayProfile& display,
                   int panelWidth, int panelHeight);
    void prepare(const CyclopeanScene& scene) override;
    void show(const CyclopeanScene& scene, GLuint panel) override;
    [[nodiscard]] const Atlas* atlas() const override { return &atlas_; }
    /// What a display of type 2d_plus_depth gets beside the picture; none on others.
    [[nodiscard]] const std::optional<DisparityView>& disparity() const { return disparity_; }

  private:
    Atlas atlas_;
    LayerMesher mesher_;
    std::unique_ptr<AtlasViews> views_;
    std::optional<DisparityView> disparity_; ///< for displays that make their views themselves
    std::unique_ptr<Interleaver> interleaver_;
};

} // namespace autostereo::gpu

#pragma once

#include "gpu/interleaver.hpp"
#include "gpu/views/kept_roots.hpp"
#include "gpu/views/layer_search.hpp"
#include "gpu/views/view_synthesis.hpp"

namespace autostereo::gpu {

/// No views at all: every sub-pixel searches the layers for the first surface behind it, at its own
/// place and for the eye that its lens sends it to. Exact for any number of eyes; what it costs
/// does not depend on how many.
class DirectSynthesis final : public ViewSynthesis {
  public:
    /// Throws GlError.
    DirectSynthesis(const PipelineParams& params, const calib::DisplayProfile& display,
                    int panelWidth, int panelHeight);
    void prepare(const CyclopeanScene& scene) override;
    void show(const CyclopeanScene& scene, GLuint panel) override;
    [[nodiscard]] std::optional<KeptShare> keptShare() const override;

  private:
    LayerSearch search_;
    std::optional<KeptRoots> kept_;
    bool skips_;
    int prepared_ = 2; ///< scenes since the last one that was shown; at first unknown
    gl::Texture positions_;
    std::unique_ptr<Interleaver> interleaver_;
};

} // namespace autostereo::gpu

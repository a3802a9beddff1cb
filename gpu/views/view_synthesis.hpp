#pragma once

#include "calib/display_profile.hpp"
#include "calib/eye_pair.hpp"
#include "gpu/atlas.hpp"
#include "gpu/fusion/cyclopean_scene.hpp"
#include "gpu/params.hpp"
#include "gpu/views/kept_share.hpp"

#include <memory>
#include <optional>

namespace autostereo::gpu {

/// The cyclopean scene -> the panel: how the picture of every view comes to its sub-pixels. All
/// methods show the same layers. They need MeshBlock at binding 0. Thread-bound.
class ViewSynthesis {
  public:
    virtual ~ViewSynthesis() = default;
    /// Once a frame: whatever does not depend on the panel's pixels.
    virtual void prepare(const CyclopeanScene& scene) = 0;
    /// Fills the panel with what was prepared; may be called again.
    virtual void show(const CyclopeanScene& scene, GLuint panel) = 0;
    /// Where the viewer's eyes are, from the next `show` on; only EyeSynthesis cares.
    virtual void setEyes(const calib::EyePair& /*eyes*/) {}
    /// Every view in a tile of its own; none where views are never drawn.
    [[nodiscard]] virtual const Atlas* atlas() const { return nullptr; }
    /// What of the panel needed no work; none where nothing is searched.
    [[nodiscard]] virtual std::optional<KeptShare> keptShare() const { return std::nullopt; }
};

/// For a panel of the given size. `method` as in params, but a display that makes its views itself
/// gets tiles. Throws GlError.
[[nodiscard]] std::unique_ptr<ViewSynthesis> makeViewSynthesis(const PipelineParams& params,
                                                               const calib::DisplayProfile& display,
                                                               int panelWidth, int panelHeight);

/// Position b of every view as an R32F texture, one texel a view, left to right.
[[nodiscard]] gl::Texture makeViewPositions(const calib::DisplayProfile& display);

} // namespace autostereo::gpu

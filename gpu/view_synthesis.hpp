#pragma once

#include "calib/display_profile.hpp"
#include "gpu/atlas.hpp"
#include "gpu/mesh_layer.hpp"
#include "gpu/params.hpp"

#include <memory>

namespace autostereo::gpu {

/// Mesh layers -> all views in the atlas. One file per method; all share the mesh, the shaders and
/// the tile layout, and give the same picture to rounding. Thread-bound.
class ViewSynthesis {
  public:
    virtual ~ViewSynthesis() = default;
    virtual void render(const MeshLayers& layers, const gl::Texture& color, const Atlas& atlas) = 0;
};

[[nodiscard]] std::unique_ptr<ViewSynthesis> makeViewSynthesis(Method method,
                                                               const calib::DisplayProfile& display,
                                                               const PipelineParams& params);

/// Position b of every view as an R32F texture, one texel a view, left to right.
[[nodiscard]] gl::Texture makeViewPositions(const calib::DisplayProfile& display);

} // namespace autostereo::gpu

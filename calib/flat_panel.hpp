#pragma once

#include "calib/panel_map.hpp"
#include "calib/picture.hpp"

namespace autostereo::calib {

/// A picture of the panel's size as every eye sees it in the panel's plane: where all views are
/// alike, a sub-pixel shows its own place, whatever eye it is for. Sub-pixels that stay dark stay
/// dark; whole views are scaled into their tiles; a depth frame says "in the panel's plane"
/// everywhere. Reentrant.
[[nodiscard]] Picture flatPanel(const Picture& picture, const PanelMap& map, int views);

} // namespace autostereo::calib

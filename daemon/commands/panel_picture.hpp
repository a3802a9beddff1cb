#pragma once

#include "calib/picture.hpp"
#include "gpu/panel.hpp"

#include <string>

namespace autostereo::daemon {

/// Pictures straight on the panel's pixels, made for no view in particular: for whoever sets up a
/// panel whose views are not right yet. The panel's context is current. Throw GlError.

/// Over the whole panel, each pixel a block.
void drawStretched(gpu::Panel& panel, const calib::Picture& picture);
/// Fitted into what a strip leaves of the panel, its shape kept.
void drawPicture(gpu::Panel& panel, const calib::Picture& picture);
/// Words over the panel's lowest quarter.
void drawStrip(gpu::Panel& panel, const std::string& text);

} // namespace autostereo::daemon

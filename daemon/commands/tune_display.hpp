#pragma once

#include "daemon/command_line.hpp"

namespace autostereo::daemon {

/// `calibrate display --keys`: the display's numbers set by eye, over test pictures on the panel
/// itself. Returns the exit code. Throws as `calibrateDisplay` does, DisplayNotFound, GlError.
int tuneDisplay(const CalibrateDisplayOptions& options);

} // namespace autostereo::daemon

#pragma once

#include "daemon/command_line.hpp"

namespace autostereo::daemon {

/// `calibrate rig` for cameras whose own numbers are known (--rig): the transform alone, from
/// listed point pairs or from the depth camera's own points of a board. Returns the exit code.
/// Throws UsageError, ConfigError, DeviceError, Refusal.
int calibrateFromPoints(const BoardOptions& options);

} // namespace autostereo::daemon

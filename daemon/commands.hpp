#pragma once

#include "daemon/command_line.hpp"

namespace autostereo::daemon {

/// Each command's whole work; the exit code is returned, failures are thrown.
int run(const RunOptions& options);
int render(const RenderOptions& options);
int check(const CheckOptions& options);
int listDevices(const DevicesOptions& options);

} // namespace autostereo::daemon

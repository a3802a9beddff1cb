#pragma once

#include "daemon/command_line.hpp"

namespace autostereo::daemon {

/// Each command's whole work; the exit code is returned, failures are thrown.
int run(const RunOptions& options);
int render(const RenderOptions& options);
int check(const CheckOptions& options);
int listDevices(const DevicesOptions& options);
int interleave(const InterleaveOptions& options);
int viewmap(const ViewmapOptions& options);
int look(const LookOptions& options);
int pattern(const PatternOptions& options);
int calibrateNoise(const CalibrateNoiseOptions& options);
int benchmark(const BenchOptions& options);
int importCalibration(const ImportOptions& options);

} // namespace autostereo::daemon

#pragma once

#include "daemon/command_line.hpp"

namespace autostereo::daemon {

/// Each command's whole work; the exit code is returned, failures are thrown.
int run(const RunOptions& options);
int record(const RecordOptions& options);
int render(const RenderOptions& options);
int check(const CheckOptions& options);
int listDevices(const DevicesOptions& options);
int interleave(const InterleaveOptions& options);
int viewmap(const ViewmapOptions& options);
int look(const LookOptions& options);
int pattern(const PatternOptions& options);
int calibrateCameras(const BoardOptions& options);
int calibrateRig(const BoardOptions& options);
int calibrateTiming(const BoardOptions& options);
int calibrateDisplay(const CalibrateDisplayOptions& options);
int calibrateNoise(const CalibrateNoiseOptions& options);
int benchmark(const BenchOptions& options);
int measureLatency(const LatencyOptions& options);
int control(const ControlOptions& options);
int importCalibration(const ImportOptions& options);

} // namespace autostereo::daemon

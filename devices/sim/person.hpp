#pragma once

#include "devices/sim/body.hpp"

#include <vector>

namespace autostereo::devices::sim {

/// The whole motion repeats after this many seconds.
constexpr double kPersonPeriodS = 6.0;

/// A person at about 1.4 m who sways, looks about and waves a hand towards the camera. A smooth,
/// periodic, pure function of time.
[[nodiscard]] std::vector<Body> personAt(double timeSeconds);

} // namespace autostereo::devices::sim

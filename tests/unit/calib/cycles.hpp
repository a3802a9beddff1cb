#pragma once

#include <cmath>

namespace autostereo::calib {

using Real = long double;

/// Distance on a circle of one cycle.
inline Real apart(Real a, Real b) { return std::abs(a - b - std::round(a - b)); }

} // namespace autostereo::calib

#pragma once

#include "devices/clock.hpp"

#include <cmath>

namespace autostereo::test {

/// So many seconds after a moment that all tests start from.
inline devices::TimePoint atSeconds(double seconds) {
    return devices::TimePoint(devices::Duration(1'000'000'000'000 + std::llround(1e9 * seconds)));
}

} // namespace autostereo::test

#pragma once

#include "devices/clock.hpp"

#include <cmath>
#include <numbers>

/// From the units that files use to those of the program: metres, radians, nanoseconds.
/// The only place where such factors stand.
namespace autostereo::config::units {

[[nodiscard]] constexpr double metresFromMm(double mm) { return mm * 1e-3; }
[[nodiscard]] constexpr double mmFromMetres(double metres) { return metres * 1e3; }
[[nodiscard]] constexpr double metresFromInches(double inches) { return inches * 0.0254; }
[[nodiscard]] constexpr double secondsFromMs(double ms) { return ms * 1e-3; }
[[nodiscard]] constexpr double msFromSeconds(double seconds) { return seconds * 1e3; }
[[nodiscard]] constexpr double radiansFromDeg(double deg) { return deg * std::numbers::pi / 180; }
[[nodiscard]] constexpr double degFromRadians(double rad) { return rad * 180 / std::numbers::pi; }
[[nodiscard]] inline devices::Duration durationFromMs(double ms) {
    return devices::Duration(std::llround(ms * 1e6));
}

} // namespace autostereo::config::units

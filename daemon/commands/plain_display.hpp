#pragma once

#include "calib/display_profile.hpp"

namespace autostereo::daemon {

/// Formats that any stereo monitor, glasses or player takes, in place of a display's own optics.
enum class PlainFormat { SideBySide, Anaglyph, DepthFrame };

/// The display with the same panel and viewer, but fed in that format: two views one eye distance
/// (63 mm) apart at the nominal distance, or one picture with its disparity.
[[nodiscard]] calib::DisplayProfile plainDisplay(const calib::DisplayProfile& display,
                                                 PlainFormat format, int width, int height);

} // namespace autostereo::daemon

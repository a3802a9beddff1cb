#pragma once

#include "calib/display_profile.hpp"

#include <string>
#include <vector>

namespace autostereo::calibrate {

/// A number of a display that photographs measure, with its place in the display's file.
struct DisplayNumber {
    std::string table;
    std::string key;
    double unit = 1;         ///< the file's number x unit = *value
    double span = 1;         ///< a change by which the fringes clearly move
    double* value = nullptr; ///< in the profile that was asked
};

/// Pitch, slant, offset and fan (or distance of the lenses), in this order, of a display whose
/// phases follow from them; empty: its kind (tables, tracked lenses, no optics) cannot be measured
/// so. The pointers live as long as the profile.
[[nodiscard]] std::vector<DisplayNumber> measuredNumbers(calib::DisplayProfile& display);

} // namespace autostereo::calibrate

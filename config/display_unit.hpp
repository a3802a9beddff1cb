#pragma once

#include "calib/display_laws.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace autostereo::config {

/// A number of a display file that was measured, in the file's own unit.
struct MeasuredValue {
    std::string table, key;
    double value = 0;
    double half95 = 0; ///< half of its 95 % interval; 0: not known
};
enum class MeasuredBy { Photographs, Eye };
/// Nothing: what the assumed display has stays; without nodes: it goes.
using MeasuredGrid = std::optional<calib::PhaseGrid>;

/// The display file of one unit: what `assumed` (a shipped display's name, a display file, a
/// Looking Glass' or CubeVi's own calibration) says, with these numbers in place of its own, each
/// marked as measured, its interval in [notes]. Reads back to the values to the last digit. Throws
/// ConfigError.
[[nodiscard]] std::string measuredDisplay(const std::string& assumed,
                                          const std::vector<MeasuredValue>& values,
                                          const MeasuredGrid& grid, MeasuredBy by);

} // namespace autostereo::config

#pragma once

#include "calib/solve/display_solver.hpp"
#include "config/display_unit.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace autostereo::daemon {

struct MeasuredDisplay {
    calib::DisplayProfile display; ///< with the numbers in it; by photographs, with its grid
    std::vector<calibrate::MeasuredNumber> numbers;
    config::MeasuredBy by = config::MeasuredBy::Photographs;
};

/// The text of one unit's display file, read back: one whose other keys overrule these numbers is
/// of no use. Throws ConfigError (a number out of its range), UsageError.
[[nodiscard]] std::string unitFile(const std::string& assumed, const std::filesystem::path& file,
                                   const MeasuredDisplay& measured);

} // namespace autostereo::daemon

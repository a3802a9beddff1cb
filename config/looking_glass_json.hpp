#pragma once

#include "calib/display_laws.hpp"
#include "config/toml_reader.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace autostereo::config {

/// What our display files and the vendor's both may say of a Looking Glass.
namespace looking_glass {
constexpr Range kPitch{1, 1000};
constexpr Range kSlope{-1000, 1000}; ///< but for what lies between -1 and 1
constexpr Range kCenter{-100, 100};
constexpr Range kDpi{10, 2000};
constexpr Range kFringe{0, 1000};
constexpr Range kCells{0, 16};
constexpr Range kCellOffset{-2, 2};

/// What is wrong with a slope in kSlope, or with the number of cells; or nothing.
[[nodiscard]] std::optional<std::string> slopeProblem(double slope);
[[nodiscard]] std::optional<std::string> cellProblem(calib::CellPattern pattern, std::size_t cells);
} // namespace looking_glass

/// A unit's own calibration as its maker's visual.json has it.
struct LookingGlassUnit {
    calib::LookingGlassCalibration lens;
    std::string serial;
    std::optional<double> viewConeDeg;
    int fringe = 0;
    /// invView and whatever else nothing uses, and warnings about numbers that no known unit has.
    std::map<std::string, std::string> notes;
    std::vector<std::string> warnings;
};

/// Takes any text; throws ConfigError, one line. `file` is its name in messages.
[[nodiscard]] LookingGlassUnit readLookingGlassJson(const std::string& file, std::string_view json);

/// What is wrong with a calibration's text, or nothing: a validator for its cache.
[[nodiscard]] std::optional<std::string> calibrationProblem(std::string_view json);

} // namespace autostereo::config

#include "config/looking_glass_json.hpp"

#include "config/display_reader.hpp"
#include "config/json_fields.hpp"
#include "config/load.hpp"
#include "config/phrases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace autostereo::config {

namespace {

using calib::CellPattern;

/// Displays serve this until they are plugged in again after Bridge's abnormal exit.
void refuseAllZeros(const JsonFields& json) {
    constexpr std::array kKeys{"pitch", "slope", "DPI", "screenW", "screenH"};
    const bool zero =
        std::ranges::all_of(kKeys, [&json](const char* key) { return json.anyNumber(key) == 0; });
    if (zero)
        json.reject("pitch", "0, and so is every number: the display served no calibration (unplug "
                             "its USB cable and plug it in again)");
}

calib::SubpixelCell readCell(JsonFields& json) {
    constexpr Range kOffset = looking_glass::kCellOffset;
    return {{{json.number("ROffsetX", kOffset), json.number("ROffsetY", kOffset)},
             {json.number("GOffsetX", kOffset), json.number("GOffsetY", kOffset)},
             {json.number("BOffsetX", kOffset), json.number("BOffsetY", kOffset)}}};
}

/// Without cells the panel is an RGB stripe, whatever the mode says.
void readCells(JsonFields& json, calib::LookingGlassCalibration& lens) {
    constexpr std::array kModes{CellPattern::Single, CellPattern::Checkerboard,
                                CellPattern::Columns, CellPattern::Staircase, CellPattern::Rows};
    const char* modeKey = json.has("CellPatternMode") ? "CellPatternMode" : "cellPatternMode";
    const auto mode = static_cast<std::size_t>(json.integer(modeKey, {0, 4}, 0));
    for (JsonFields& cell : json.objects("subpixelCells", looking_glass::kCells))
        lens.cells.push_back(readCell(cell));
    if (lens.cells.empty()) return;
    lens.pattern = kModes.at(mode);
    if (const auto problem = looking_glass::cellProblem(lens.pattern, lens.cells.size()))
        json.reject("subpixelCells", *problem);
}

/// Ranges of all units and templates that are known.
void noteUnusual(LookingGlassUnit& unit) {
    const auto look = [&unit](const char* key, double value, Range usual) {
        if (value >= usual.low && value <= usual.high) return;
        unit.warnings.push_back(std::string(key) + " = " + plain(value) +
                                " is unusual (known units have " + plain(usual.low) + " to " +
                                plain(usual.high) + ')');
    };
    look("pitch", unit.lens.pitch, {30, 90});
    look("|slope|", std::abs(unit.lens.slope), {4, 9});
    look("center", unit.lens.center, {-1, 1});
    look("DPI", unit.lens.dpi, {100, 600});
    look("viewCone", unit.viewConeDeg.value_or(40), {20, 70});
}

} // namespace

std::optional<std::string> looking_glass::slopeProblem(double slope) {
    if (std::abs(slope) >= 1) return std::nullopt;
    return plain(slope) + " is out of range (allowed -1000 to -1 and 1 to 1000)";
}

std::optional<std::string> looking_glass::cellProblem(CellPattern pattern, std::size_t cells) {
    const auto needed = static_cast<std::size_t>(calib::cellCount(pattern));
    if (cells >= needed) return std::nullopt;
    return "has " + std::to_string(cells) +
           " rows, too few for its cell pattern (allowed at least " + std::to_string(needed) + ')';
}

LookingGlassUnit readLookingGlassJson(const std::string& file, std::string_view text) {
    JsonFields json(file, text);
    refuseAllZeros(json);
    LookingGlassUnit unit;
    auto& lens = unit.lens;
    unit.serial = json.text("serial");
    lens.pitch = json.number("pitch", looking_glass::kPitch);
    lens.slope = json.number("slope", looking_glass::kSlope);
    if (const auto problem = looking_glass::slopeProblem(lens.slope))
        json.reject("slope", *problem);
    lens.center = json.number("center", looking_glass::kCenter);
    lens.dpi = json.number("DPI", looking_glass::kDpi);
    lens.screenWidth = json.integer("screenW", kPanelPixels);
    lens.screenHeight = json.integer("screenH", kPanelPixels);
    lens.flipImageX = json.flag("flipImageX");
    lens.flipImageY = json.flag("flipImageY", false);
    lens.flipSubpixels = json.flag("flipSubp", false);
    if (json.has("viewCone")) unit.viewConeDeg = json.number("viewCone", kConeDeg);
    unit.fringe = static_cast<int>(std::lround(json.number("fringe", looking_glass::kFringe, 0)));
    readCells(json, lens);
    unit.notes = json.rest();
    noteUnusual(unit);
    if (json.anyNumber("verticalAngle").value_or(0) != 0)
        unit.warnings.emplace_back("verticalAngle is not 0, and not used");
    return unit;
}

std::optional<std::string> calibrationProblem(std::string_view json) try {
    static_cast<void>(readLookingGlassJson("", json));
    return std::nullopt;
} catch (const ConfigError& error) {
    constexpr std::string_view kNoFile = ": ";
    return error.what() + kNoFile.size();
}

} // namespace autostereo::config

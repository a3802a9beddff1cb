#include "config/display_unit.hpp"

#include "config/load.hpp"
#include "config/phrases.hpp"
#include "config/text_file.hpp"
#include "config/vendor_calibration.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace autostereo::config {

namespace {

/// Nodes of a measured grid are kept to this part of a cycle, a hundredth of what they are good to.
constexpr double kGridSteps = 1e6;

/// What a unit's file begins with: the assumed one's own text, or a shipped display as its base.
toml::table startingFrom(const std::string& assumed) {
    const auto shipped = displayNames();
    if (std::ranges::find(shipped, assumed) != shipped.end())
        return toml::table{{"type", loadDisplay(assumed).type}, {"base", assumed}};
    std::string text = readTextFile(assumed);
    if (std::filesystem::path(assumed).extension() == ".json")
        text = importDisplay(vendorOf(text).value_or(Vendor::LookingGlass), assumed, text).toml;
    try {
        return toml::parse(text, assumed);
    } catch (const toml::parse_error& error) {
        throw ConfigError(oneLine(assumed + ": syntax: " + std::string(error.description())));
    }
}

toml::table& tableIn(toml::table& root, const std::string& name) {
    if (root.get_as<toml::table>(name) == nullptr) root.insert_or_assign(name, toml::table{});
    return *root.get_as<toml::table>(name);
}

void setGrid(toml::table& root, const calib::PhaseGrid& grid) {
    root.erase("phase_grid");
    tableIn(root, "provenance").erase("cycles");
    if (grid.cycles.empty()) return;
    toml::array cycles;
    for (const double node : grid.cycles)
        cycles.push_back(std::round(node * kGridSteps) / kGridSteps);
    root.insert(
        "phase_grid",
        toml::table{{"columns", grid.columns}, {"rows", grid.rows}, {"cycles", std::move(cycles)}});
    tableIn(root, "provenance").insert("cycles", "measured");
}

} // namespace

std::string measuredDisplay(const std::string& assumed, const std::vector<MeasuredValue>& values,
                            const MeasuredGrid& grid, MeasuredBy by) {
    toml::table root = startingFrom(assumed);
    for (const MeasuredValue& value : values) {
        tableIn(root, value.table).insert_or_assign(value.key, value.value);
        tableIn(root, "provenance").insert_or_assign(value.key, "measured");
        if (value.half95 > 0)
            tableIn(root, "notes").insert_or_assign(value.key + "_95", "+- " + plain(value.half95));
        else
            tableIn(root, "notes").erase(value.key + "_95"); // of an earlier measurement
    }
    if (grid) setGrid(root, *grid);
    std::ostringstream text;
    text << (by == MeasuredBy::Eye ? "# Set by eye with" : "# Measured from photographs by")
         << " autostereo calibrate display; the rest is its model's.\n"
         << root << '\n';
    return text.str();
}

} // namespace autostereo::config

#include "config/vendor_calibration.hpp"

#include "config/display_reader.hpp"
#include "config/json_fields.hpp"
#include "config/load.hpp"
#include "config/looking_glass_json.hpp"
#include "config/phrases.hpp"
#include "config/toml_text.hpp"

#include <array>

namespace autostereo::config {

namespace {

/// The shipped display of each model, by the letters that its serials start with. Of models with
/// the same panel the first one stands for a unit without a serial.
struct Model {
    std::string_view serial;
    int width, height;
    std::string_view display;
};
constexpr std::array kModels{Model{"LKG-2K", 2560, 1600, "looking-glass-8.9-gen1"},
                             Model{"LKG-P", 1536, 2048, "looking-glass-portrait-template"},
                             Model{"LKG-A", 3840, 2160, "looking-glass-16-gen2"},
                             Model{"LKG-4K", 3840, 2160, "looking-glass-15.6-gen1"},
                             Model{"LKG-J", 3840, 2160, "looking-glass-16-landscape-gen3"},
                             Model{"LKG-H", 2160, 3840, "looking-glass-16-portrait-gen3"},
                             Model{"LKG-B", 7680, 4320, "looking-glass-32-gen2"},
                             Model{"LKG-8K", 7680, 4320, "looking-glass-8k-gen1"},
                             Model{"LKG-D", 7680, 4320, "looking-glass-65"},
                             Model{"LKG-L", 7680, 4320, "looking-glass-32-landscape-gen3"},
                             Model{"LKG-K", 4320, 7680, "looking-glass-32-portrait-gen3"},
                             Model{"LKG-E", 1440, 2560, "looking-glass-go"},
                             Model{"LKG-F", 1536, 2048, "looking-glass-kiosk"},
                             Model{"LKG-N", 2880, 5120, "looking-glass-27-portrait-gen3"},
                             Model{"LKG-R", 5120, 2880, "looking-glass-27-landscape-gen3"}};

std::string baseFor(const std::string& file, const LookingGlassUnit& unit) {
    for (const Model& model : kModels)
        if (unit.serial.starts_with(model.serial)) return std::string(model.display);
    const int width = unit.lens.screenWidth, height = unit.lens.screenHeight;
    for (const Model& model : kModels)
        if (width == model.width && height == model.height) return std::string(model.display);
    throw ConfigError(oneLine(file + ": screenW: no model is known of " + std::to_string(width) +
                              'x' + std::to_string(height) + ", nor a serial of \"" + unit.serial +
                              "\" (name a display to build on with --base)"));
}

/// "Looking Glass Go 6 inch, unit LKG-E11076"; one shipped display is itself a unit.
std::string unitOf(const std::string& base, const std::string& serial) {
    const std::string model = loadDisplay(base).model;
    return model.substr(0, model.find(", unit ")) + ", unit " +
           (serial.empty() ? "without a serial" : serial);
}

void writeOrder(TomlText& toml, const ImportChoices& choices, calib::ViewOrder usual) {
    const bool rising = choices.order.value_or(usual) == calib::ViewOrder::LeftToRight;
    toml.comment("The other way round where depth looks inside out.");
    toml.text("view_order", rising ? "left_to_right" : "right_to_left");
}

void writeLens(TomlText& toml, const LookingGlassUnit& unit) {
    constexpr std::array kPatterns{"single", "checkerboard", "columns", "staircase", "rows"};
    const auto& lens = unit.lens;
    toml.table("lens");
    toml.number("pitch", lens.pitch);
    toml.number("slope", lens.slope);
    toml.number("center", lens.center);
    toml.number("dpi", lens.dpi);
    toml.boolean("flip_image_x", lens.flipImageX);
    toml.boolean("flip_image_y", lens.flipImageY);
    toml.boolean("flip_subpixels", lens.flipSubpixels);
    toml.integer("fringe", unit.fringe);
    toml.text("cell_pattern", kPatterns.at(static_cast<std::size_t>(lens.pattern)));
    std::vector<std::vector<double>> cells;
    for (const auto& [r, g, b] : lens.cells)
        cells.push_back({r[0], r[1], g[0], g[1], b[0], b[1]});
    toml.rows("cells", cells);
}

void writePerUnit(TomlText& toml, std::initializer_list<std::string_view> keys) {
    toml.table("provenance");
    for (const std::string_view key : keys)
        toml.text(key, "per-unit");
}

/// What the base cannot know of this unit; its view cone may be missing, then the model's counts.
std::string lookingGlassToml(const LookingGlassUnit& unit, const std::string& base,
                             const ImportChoices& choices) {
    TomlText toml;
    toml.comment("A Looking Glass unit's own calibration, imported; the rest is its model's.");
    toml.text("type", "looking_glass");
    toml.text("base", base);
    toml.text("model", unitOf(base, unit.serial));
    toml.table("panel");
    toml.integer("width", unit.lens.screenWidth);
    toml.integer("height", unit.lens.screenHeight);
    toml.table("viewing");
    if (unit.viewConeDeg) toml.number("cone_deg", *unit.viewConeDeg);
    writeOrder(toml, choices, calib::ViewOrder::LeftToRight);
    writeLens(toml, unit);
    writePerUnit(toml, {"pitch", "slope", "center", "dpi", "flip_image_x", "cells"});
    toml.text("cone_deg", unit.viewConeDeg ? "per-unit" : "assumed");
    toml.table("notes");
    auto notes = unit.notes;
    if (!unit.serial.empty()) notes["serial"] = unit.serial;
    for (const std::string& warning : unit.warnings)
        notes["warning"] += (notes["warning"].empty() ? "" : "; ") + warning;
    toml.texts(notes);
    return toml.str();
}

ImportedDisplay importLookingGlass(const std::string& file, std::string_view json,
                                   const ImportChoices& choices) {
    const LookingGlassUnit unit = readLookingGlassJson(file, json);
    const std::string base = choices.base ? *choices.base : baseFor(file, unit);
    return {base, lookingGlassToml(unit, base, choices), unit.warnings};
}

/// The object with the lens numbers: the text itself, or the vendor program's whole answer.
JsonFields cubeviConfig(JsonFields json) {
    for (const char* wrapper : {"response_data", "config"})
        if (auto inner = json.object(wrapper)) json = std::move(*inner);
    return json;
}

ImportedDisplay importCubevi(const std::string& file, std::string_view json,
                             const ImportChoices& choices) {
    JsonFields fields = cubeviConfig(JsonFields(file, json));
    const std::string base = choices.base.value_or("cubevi-c1");
    TomlText toml;
    toml.comment("A CubeVi unit's own calibration, imported; the rest is its model's.");
    toml.text("type", "cubevi");
    toml.text("base", base);
    toml.text("model", unitOf(base, fields.text("deviceId")));
    toml.table("viewing");
    writeOrder(toml, choices, calib::ViewOrder::RightToLeft);
    toml.table("lens");
    toml.number("subpixels_per_lens", fields.number("lineNumber", cubevi::kSubpixelsPerLens));
    toml.number("slope", fields.number("obliquity", cubevi::kSlope));
    toml.number("offset_subpixels", fields.number("deviation", cubevi::kOffset));
    writePerUnit(toml, {"subpixels_per_lens", "slope", "offset_subpixels"});
    toml.table("notes");
    toml.texts(fields.rest());
    return {base, toml.str(), {}};
}

} // namespace

std::optional<Vendor> vendorOf(std::string_view json) try {
    JsonFields fields("", json);
    if (fields.has("pitch")) return Vendor::LookingGlass;
    if (cubeviConfig(std::move(fields)).has("lineNumber")) return Vendor::Cubevi;
    return std::nullopt;
} catch (const ConfigError&) {
    return std::nullopt;
}

ImportedDisplay importDisplay(Vendor vendor, const std::string& file, std::string_view json,
                              const ImportChoices& choices) {
    return vendor == Vendor::Cubevi ? importCubevi(file, json, choices)
                                    : importLookingGlass(file, json, choices);
}

} // namespace autostereo::config

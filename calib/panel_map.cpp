#include "calib/panel_map.hpp"

#include "calib/phase_laws.hpp"

#include <stdexcept>

namespace autostereo::calib {

namespace {

PhaseTables tablesOf(const DisplayProfile& display, int vendorViews, int width, int height) {
    if (const auto* table = std::get_if<ViewTable>(&display.law))
        return phaseTables(*table, vendorViews, width, height);
    if (const auto* lut = std::get_if<ViewLut>(&display.law)) {
        PhaseTables tables(width, height);
        tables.lut = lut->phases;
        return tables;
    }
    if (const auto affine = affinePhase(display.law, vendorViews))
        return phaseTables(*affine, width, height);
    throw std::invalid_argument("display " + display.name + ": type " + display.type +
                                " has no phase of its own");
}

} // namespace

ViewMap makeViewMap(const DisplayProfile& display, int width, int height) {
    const int views =
        display.remap.empty() ? display.views : static_cast<int>(display.remap.size());
    ViewMap map;
    map.tables = tablesOf(display, views, width, height);
    map.views = static_cast<std::uint32_t>(views);
    map.reversed = display.order == ViewOrder::RightToLeft;
    if (const auto* unit = std::get_if<LookingGlassCalibration>(&display.law))
        map.upsideDown = unit->flipImageY;
    for (const int shown : display.remap)
        map.remap.push_back(shown == DisplayProfile::kBlack ? ViewMap::kBlack
                                                            : static_cast<std::uint32_t>(shown));
    return map;
}

PanelMap panelMap(const DisplayProfile& display, int width, int height,
                  const std::vector<glm::dvec3>& eyes) {
    if (std::holds_alternative<LineScreen>(display.law) ||
        std::holds_alternative<TrackedLens>(display.law))
        return bandMap(display, width, height, eyes);
    if (const auto* tiles = std::get_if<TileFrame>(&display.law)) return *tiles;
    if (const auto* depth = std::get_if<DepthFrame>(&display.law)) return *depth;
    return makeViewMap(display, width, height);
}

} // namespace autostereo::calib

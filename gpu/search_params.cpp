#include "gpu/search_params.hpp"

#include "calib/optics.hpp"
#include "gpu/scene/scene_views.hpp"

namespace autostereo::gpu {

namespace {

/// From red to green to blue, panel widths.
double channelStep(const calib::DisplayProfile& display) {
    const auto layout = calib::subpixelLayout(display);
    if (!layout) return 0;
    const auto& [red, green, blue] = layout->offsetsM.front();
    return (blue.x - red.x) / 2 / display.widthM;
}

} // namespace

SearchParams searchParams(const calib::DisplayProfile& display, const calib::PanelMap& map,
                          ViewPositions positions) {
    SearchParams search;
    search.views = display.views;
    search.channelStep = channelStep(display);
    const auto* views = std::get_if<calib::ViewMap>(&map);
    // Sub-pixels that the maker gave to views one by one show those.
    if (views == nullptr || !views->remap.empty() || positions == ViewPositions::OfViews)
        return search;
    search.continuous = display.views > 1;
    const double first = calib::viewPosition(display, 0);
    const double step = calib::viewPosition(display, 1) - first;
    search.positionPerCycle = step * display.views;
    search.firstPosition = first - step / 2;
    if (views->reversed) {
        search.firstPosition += search.positionPerCycle;
        search.positionPerCycle = -search.positionPerCycle;
    }
    return search;
}

std::vector<std::string> definesOf(const std::optional<SearchParams>& search) {
    if (!search) return {};
    std::vector<std::string> defines{"SEARCH"};
    if (search->rootsOnly) defines.emplace_back("ROOTS");
    if (search->continuous) defines.emplace_back("CONTINUOUS");
    if (!search->scene) return defines;
    defines.emplace_back("SURFACES");
    const std::vector<std::string> shading = definesOf(*search->scene);
    defines.insert(defines.end(), shading.begin(), shading.end());
    return defines;
}

} // namespace autostereo::gpu

#include "config/display_reader.hpp"
#include "config/phrases.hpp"

namespace autostereo::config {

namespace {

using Rows = std::vector<std::vector<int>>;

/// Glasses: which eye each of R, G, B belongs to (0 left, 1 right).
std::vector<int> readGlasses(TomlReader& root) {
    return root.choice<std::vector<int>>(
        "glasses",
        {{"red-cyan", {0, 1, 1}}, {"green-magenta", {1, 0, 1}}, {"amber-blue", {0, 0, 1}}},
        std::vector<int>{0, 1, 1});
}

Rows interlaced(TomlReader& root, std::string_view type) {
    if (type == "row") return {{0}, {1}};
    if (type == "column") return {{0, 0, 0, 1, 1, 1}};
    if (type == "checkerboard") return {{0, 0, 0, 1, 1, 1}, {1, 1, 1, 0, 0, 0}};
    if (type == "anaglyph") return {readGlasses(root)};
    return {{0}}; // flat
}

} // namespace

calib::DisplayLaw readFrame(DisplayReader& display, std::string_view type) {
    auto& profile = display.profile;
    if (type == "quilt") {
        const auto& quilt = profile.quilt;
        return calib::TileFrame{quilt.columns, quilt.rows, false};
    }
    profile.views = type == "flat" ? 1 : 2;
    profile.fan = type == "flat" ? calib::Fan::Centres : calib::Fan::Edges;
    const bool swapped = type != "flat" && display.root.boolean("swap_eyes", false);
    if (type == "side_by_side") return calib::TileFrame{2, 1, true, swapped};
    if (type == "top_bottom") return calib::TileFrame{1, 2, true, swapped};
    if (swapped) profile.order = calib::ViewOrder::RightToLeft;
    return calib::ViewTable{interlaced(display.root, type)};
}

calib::DepthFrame readDepthFrame(DisplayReader& display) {
    constexpr Range kByte{0, 255};
    constexpr int kHeaderPixels = 256;
    auto table = display.root.table("frame");
    calib::DepthFrame frame;
    frame.contentType = table.integer("content_type", kByte, frame.contentType);
    frame.factor = table.integer("factor", kByte, frame.factor);
    frame.offset = table.integer("offset", kByte, frame.offset);
    frame.header = table.boolean("header", true);
    frame.screenLevel = display.physical(table, "screen_level", {0, 255});
    frame.gain = display.physical(table, "gain", {1, 1e6});
    if (display.profile.width % 2 != 0 ||
        (display.profile.width != 0 && display.profile.width < kHeaderPixels))
        display.root.table("panel").reject("width", "has to be even and hold the header (allowed "
                                                    "256 to 16384)");
    display.profile.views = 1;
    return frame;
}

calib::ViewTable readTable(DisplayReader& display) {
    auto lens = display.root.table("lens");
    calib::ViewTable table;
    display.noteLensOrigin("table");
    const double last = display.profile.remap.empty()
                            ? display.profile.views - 1
                            : static_cast<double>(display.profile.remap.size()) - 1;
    for (const auto& row : lens.numberRows("table", {1, 64}, {1, 3 * 64}, {0, last})) {
        auto& views = table.rows.emplace_back();
        for (const double view : row) {
            views.push_back(static_cast<int>(view));
            if (views.back() != view)
                lens.reject("table", plain(view) + " is no view (allowed whole numbers)");
        }
    }
    return table;
}

} // namespace autostereo::config

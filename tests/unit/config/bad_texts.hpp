#pragma once

#include "config/load.hpp"
#include "tests/unit/config/temp_folder.hpp"

#include <string>

/// One display of each family, good but for what a case changes.
namespace autostereo::config::bad {

#define PANEL "panel = { width = 1920, height = 1080, width_mm = 500 }\n"
#define VIEWS                                                                                      \
    "viewing = { distance_m = 0.7, cone_deg = 30, views = 8, view_order = \"right_to_left\", fan " \
    "= \"centres\" }\n"
#define REST                                                                                       \
    "quilt = { columns = 4, rows = 2, tile_width = 640, tile_height = 360 }\n"                     \
    "depth_budget = { far = -0.02, near = 0.02 }\n"
#define ORIGINS                                                                                    \
    "[provenance]\n"                                                                               \
    "width_mm = \"measured\"\n"                                                                    \
    "distance_m = \"measured\"\n"                                                                  \
    "cone_deg = \"measured\"\n"

constexpr const char* kVanBerkel = "type = \"van_berkel\"\nmodel = \"bad\"\n" PANEL VIEWS REST R"(
[lens]
subpixels_per_lens = 8
row_shift_subpixels = 1
offset_subpixels = 0
)" ORIGINS R"(subpixels_per_lens = "per-unit"
row_shift_subpixels = "per-unit"
offset_subpixels = "per-unit"
)";

constexpr const char* kLinear = "type = \"linear\"\nmodel = \"bad\"\n" PANEL VIEWS REST R"(
[lens]
per_column = 0.3
per_row = 0.1
channel = [0, 0.1, 0.2]
offset = 0
[phase_grid]
columns = 2
rows = 2
cycles = [0, 0, 0, 0]
)" ORIGINS R"(per_column = "per-unit"
per_row = "per-unit"
channel = "per-unit"
offset = "per-unit"
cycles = "per-unit"
)";

constexpr const char* kGlass = "type = \"looking_glass\"\nmodel = \"bad\"\n"
                               "panel = { width = 1920, height = 1080 }\n" VIEWS REST R"(
[lens]
pitch = 50
slope = -7
center = 0
dpi = 300
flip_image_x = false
[provenance]
distance_m = "measured"
cone_deg = "measured"
pitch = "per-unit"
slope = "per-unit"
center = "per-unit"
dpi = "per-unit"
flip_image_x = "per-unit"
)";

constexpr const char* kCubevi = "type = \"cubevi\"\nmodel = \"bad\"\n" PANEL VIEWS REST R"(
[lens]
subpixels_per_lens = 19.6
slope = 0.1
offset_subpixels = 0
)" ORIGINS R"(subpixels_per_lens = "per-unit"
slope = "per-unit"
offset_subpixels = "per-unit"
)";

constexpr const char* kTable = "type = \"table\"\nmodel = \"bad\"\n" PANEL VIEWS REST R"(
[lens]
table = [[0, 1, 2], [3, 4, 5]]
)" ORIGINS "table = \"per-unit\"\n";

constexpr const char* kScreen = "type = \"line_screen\"\nmodel = \"bad\"\n" PANEL
                                "viewing = { distance_m = 0.7, cone_deg = 5, views = 2, "
                                "view_order = \"left_to_right\", fan = \"edges\" }\n" REST R"(
[barrier]
lines_per_m = 900
duty_cycle = 0.75
thickness_mm = 5
angle_deg = 7
shift_mm = 0
)" ORIGINS R"(lines_per_m = "per-unit"
duty_cycle = "per-unit"
thickness_mm = "per-unit"
angle_deg = "per-unit"
shift_mm = "per-unit"
)";

constexpr const char* kTracked = "type = \"two_view_tracked\"\nmodel = \"bad\"\n" PANEL
                                 "viewing = { distance_m = 0.7, cone_deg = 5, views = 2, "
                                 "view_order = \"left_to_right\", fan = \"edges\" }\n" REST R"(
[lens]
period_px = 5
row_increment_px = 0.2
init_px = 0
fill_px = 1
eye_gain_px = -25
z_bias_m = 0
)" ORIGINS R"(period_px = "per-unit"
row_increment_px = "per-unit"
init_px = "per-unit"
fill_px = "per-unit"
eye_gain_px = "per-unit"
z_bias_m = "per-unit"
)";

constexpr const char* kDepth = "type = \"2d_plus_depth\"\nmodel = \"bad\"\n" PANEL
                               "viewing = { distance_m = 3, cone_deg = 20 }\n" REST R"(
[frame]
factor = 64
screen_level = 127.5
gain = 3000
)" ORIGINS R"(screen_level = "measured"
gain = "measured"
)";

constexpr const char* kFlat = "type = \"anaglyph\"\nmodel = \"bad\"\nglasses = \"red-cyan\"\n" PANEL
                              "viewing = { distance_m = 0.6, cone_deg = 30 }\n" REST ORIGINS;

constexpr const char* kQuilt = "type = \"quilt\"\nmodel = \"bad\"\n" PANEL VIEWS REST ORIGINS;

#undef PANEL
#undef VIEWS
#undef REST
#undef ORIGINS

struct Case {
    const char* name;
    const char* text;
    const char* from; ///< "": all of it
    const char* to;
    const char* message; ///< whole, or its beginning where it ends in the list of all displays
};

/// What loading such a text throws, or "no error".
inline std::string messageOf(const std::string& text) {
    return test::messageOf<ConfigError>([&] { (void)displayFromText("x.toml", text); });
}

} // namespace autostereo::config::bad

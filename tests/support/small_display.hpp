#pragma once

#include <string>

namespace autostereo::test {

/// A display file: eight views on a slanted lens as on slanted-8view-1080p, but so many pixels
/// (even numbers), and measured, so that nothing warns of a template.
inline std::string smallDisplayText(int width, int height) {
    const auto text = [](double number) { return std::to_string(number); };
    constexpr double kPixelMm = 531.3 / 320;
    return "type = \"van_berkel\"\nmodel = \"small test panel\"\n[panel]\nwidth = " +
           std::to_string(width) + "\nheight = " + std::to_string(height) +
           "\nwidth_mm = " + text(kPixelMm * width) + R"(
[viewing]
distance_m = 1.0
cone_deg = 25.64
views = 8
view_order = "right_to_left"
fan = "centres"
[lens]
subpixels_per_lens = 8
row_shift_subpixels = 1
offset_subpixels = 0
[quilt]
columns = 4
rows = 2
tile_width = )" +
           std::to_string(width / 2) + "\ntile_height = " + std::to_string(height / 2) + R"(
[depth_budget]
far = -0.02
near = 0.02
[provenance]
width_mm = "measured"
distance_m = "measured"
cone_deg = "measured"
subpixels_per_lens = "measured"
row_shift_subpixels = "measured"
offset_subpixels = "measured"
)";
}

} // namespace autostereo::test

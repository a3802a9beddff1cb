#include "calib/panel_map.hpp"
#include "calib/phase_laws.hpp"
#include "config/load.hpp"
#include "tests/support/data.hpp"
#include "tests/unit/config/temp_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace autostereo::config {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Sub-pixels per lens along a row.
double subpixelsPerLens(const calib::DisplayProfile& display) {
    return 3 / std::abs(calib::affinePhase(display.law, display.views)->perColumn);
}

/// Vendor's view of a sub-pixel, from the phase alone.
int viewOf(const calib::DisplayProfile& display, int x, int y, int c) {
    const calib::ViewMap map = calib::makeViewMap(display, 200, 100);
    return static_cast<int>(map.phase(x, y, c) * static_cast<std::uint64_t>(map.views) >> 32U);
}

class LoadDisplay : public test::TempFolder {};

TEST_F(LoadDisplay, shippedNames) {
    const auto names = displayNames();
    EXPECT_EQ(names.size(), 41U);
    EXPECT_TRUE(std::ranges::is_sorted(names));
    for (const char* name : {"barrier-5view", "cubevi-c1", "generic-side-by-side",
                             "looking-glass-8.9-gen1", "looking-glass-portrait", "preview",
                             "slanted-8view-1080p", "varrier-scylla-tile", "wowvx-42"})
        EXPECT_TRUE(std::ranges::binary_search(names, name)) << name;
}

TEST_F(LoadDisplay, shippedProfilesAreWhole) {
    for (const std::string& name : displayNames()) {
        SCOPED_TRACE(name);
        const calib::DisplayProfile display = loadDisplay(name);
        EXPECT_EQ(display.name, name);
        EXPECT_FALSE(display.model.empty());
        EXPECT_GT(display.widthM, 0);
        EXPECT_LT(display.disparityFar, 0);
        EXPECT_GT(display.disparityNear, 0);
        EXPECT_GE(display.quilt.columns * display.quilt.rows, display.views);
        EXPECT_FALSE(display.provenance.empty());

        const auto fromDisk =
            loadDisplay((test::sourceDir() / "config/displays" / (name + ".toml")).string());
        EXPECT_EQ(fromDisk.name, name);
        EXPECT_EQ(fromDisk.model, display.model);
        EXPECT_EQ(fromDisk.law.index(), display.law.index());
    }
}

TEST_F(LoadDisplay, portraitHasTheUnitsNumbers) {
    const calib::DisplayProfile display = loadDisplay("looking-glass-portrait");
    const auto& unit = std::get<calib::LookingGlassCalibration>(display.law);
    EXPECT_EQ(unit.pitch, 52.56046553048362);
    EXPECT_EQ(unit.slope, -7.1423088016812);
    EXPECT_EQ(unit.center, 0.47345216539737284);
    EXPECT_EQ(unit.dpi, 324);
    EXPECT_EQ(unit.screenWidth, 1536);
    EXPECT_EQ(unit.screenHeight, 2048);
    EXPECT_FALSE(unit.flipImageX);
    EXPECT_NEAR(subpixelsPerLens(display), 18.67, 0.01); // 3 dpi / (pitch cos atan(1/slope))
    EXPECT_NEAR(display.widthM, 0.12042, 1e-5);          // 1536 pixels of 25.4 mm / 324
    EXPECT_DOUBLE_EQ(display.coneRad, 40 * kDegree);
    EXPECT_EQ(display.viewingDistanceM, 0.5);
    EXPECT_EQ(display.views, 48);
    EXPECT_EQ(display.order, calib::ViewOrder::LeftToRight);
    EXPECT_EQ(display.provenance.at("pitch"), "per-unit");
    EXPECT_EQ(display.provenance.at("distance_m"), "assumed");
    EXPECT_FALSE(display.placeholder);
}

// Alioscopy's published rows, counted from 0: 0 1 2 ..., then 7 0 1 ..., then 6 7 0 ...
TEST_F(LoadDisplay, eightViewPatternIsThePublishedOne) {
    const calib::DisplayProfile display = loadDisplay("slanted-8view-1080p");
    EXPECT_DOUBLE_EQ(subpixelsPerLens(display), 8);
    EXPECT_EQ(display.order, calib::ViewOrder::RightToLeft);
    EXPECT_DOUBLE_EQ(display.widthM, 0.5313);
    EXPECT_TRUE(display.placeholder);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(viewOf(display, x, y, c), (3 * x + c - y + 16) % 8) << x << ' ' << y;
}

TEST_F(LoadDisplay, fiveViewPattern) {
    const calib::DisplayProfile display = loadDisplay("barrier-5view");
    EXPECT_EQ(display.width, 1600);
    EXPECT_EQ(display.height, 1200);
    EXPECT_EQ(display.order, calib::ViewOrder::RightToLeft);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x)
            ASSERT_EQ(viewOf(display, x, y, 1), (3 * x + 1 - y + 10) % 5) << x << ' ' << y;
}

TEST_F(LoadDisplay, previewIsAnaglyphOnAnyMonitor) {
    const calib::DisplayProfile display = loadDisplay("preview");
    EXPECT_EQ(display.width, 0);
    EXPECT_EQ(display.views, 2);
    EXPECT_EQ(display.fan, calib::Fan::Edges);
    EXPECT_EQ(viewOf(display, 123, 45, 0), 0); // red: left eye
    EXPECT_EQ(viewOf(display, 123, 45, 1), 1);
    EXPECT_EQ(viewOf(display, 123, 45, 2), 1);
    // The two ends of the fan are one eye distance apart; four digits of cone_deg give 2 um.
    EXPECT_NEAR(2 * display.viewingDistanceM * std::tan(display.coneRad / 2), 0.063, 2e-6);
    EXPECT_FALSE(display.placeholder);
}

TEST_F(LoadDisplay, previewCanBeFlat) {
    write("flat.toml", R"(type = "flat"
model = "flat"
panel = { width = 640, height = 480, width_mm = 300 }
viewing = { distance_m = 0.6, cone_deg = 6 }
quilt = { columns = 1, rows = 1, tile_width = 640, tile_height = 480 }
depth_budget = { far = -0.01, near = 0.01 }
provenance = { width_mm = "measured", distance_m = "assumed", cone_deg = "assumed" }
)");
    const calib::DisplayProfile display = loadDisplay("flat.toml");
    EXPECT_EQ(display.views, 1);
    EXPECT_EQ(display.fan, calib::Fan::Centres);
    EXPECT_EQ(viewOf(display, 7, 8, 0), 0);
    EXPECT_DOUBLE_EQ(display.heightM(), 0.225);
}

TEST_F(LoadDisplay, unknownNameListsTheShippedOnes) {
    const auto message = [](const char* name) {
        return test::messageOf<ConfigError>([&] { (void)loadDisplay(name); });
    };
    EXPECT_EQ(message("portrait"),
              "display: \"portrait\" is no profile and no file *.toml (did you mean "
              "looking-glass-16-portrait-gen3, looking-glass-27-portrait-gen3, "
              "looking-glass-32-portrait-gen3, looking-glass-portrait, "
              "looking-glass-portrait-template?)");
    EXPECT_EQ(message("preveiw"),
              "display: \"preveiw\" is no profile and no file *.toml (did you mean preview?)");
    EXPECT_TRUE(message("xyz").starts_with("display: \"xyz\" is no profile and no file *.toml "
                                           "(allowed barrier-5view, barrier-8view, "));
    EXPECT_EQ(test::messageOf<ConfigError>([] { (void)loadDisplay("portrait.toml"); }),
              "portrait.toml: cannot be read: No such file or directory");
}

} // namespace
} // namespace autostereo::config

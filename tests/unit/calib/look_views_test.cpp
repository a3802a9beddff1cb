// Views that differ clearly go onto the panel by the product's map; an eye in the middle of a
// view's zone has to see that view, and between views what lies between.

#include "calib/look.hpp"
#include "calib/panel_map.hpp"
#include "config/load.hpp"
#include "tests/support/image_compare.hpp"
#include "tests/unit/calib/seen_light.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace autostereo::calib {
namespace {

/// A corner of the panel as large as the whole, a quarter of its size: same glass, less time.
DisplayProfile quarter(DisplayProfile display) {
    display.width /= 4;
    display.height /= 4;
    display.widthM /= 4;
    if (auto* unit = std::get_if<LookingGlassCalibration>(&display.law)) {
        unit->screenWidth = display.width;
        unit->screenHeight = display.height;
    }
    return display;
}

/// The slanted six-view table of de Sorbier 2008, Figure 4, with lenses one pixel wide.
DisplayProfile sixViewTable() {
    DisplayProfile display;
    display.width = 480;
    display.height = 300;
    display.widthM = 0.1;
    display.viewingDistanceM = 0.6;
    display.coneRad = 0.35;
    display.views = 6;
    display.order = ViewOrder::RightToLeft;
    display.law = ViewTable{{{0, 2, 4}, {5, 1, 3}, {4, 0, 2}, {3, 5, 1}, {2, 4, 0}, {1, 3, 5}}};
    const double pixel = display.widthM / display.width;
    display.optics = {Optics::Kind::Lens,
                      pixel / (2 * std::tan(0.35 / 2) + pixel / display.viewingDistanceM)};
    return display;
}

/// Smooth in x and y, and clearly another for each view, smoothly so.
std::uint8_t scene(double b, double u, double v, int c) {
    constexpr double kTurn = 2 * std::numbers::pi;
    const double wave = std::sin(kTurn * (1.5 * u + 0.8 * b + 0.3 * c)) +
                        std::cos(kTurn * (1.2 * v - 0.5 * b + 0.2 * c * u));
    return static_cast<std::uint8_t>(std::lround(128 + 50 * wave));
}

using Rgb = std::vector<std::uint8_t>;

/// Every sub-pixel filled by what a function says about it.
template<class Position>
Rgb filled(const DisplayProfile& display, Position position) {
    Rgb rgb;
    rgb.reserve(3 * static_cast<std::size_t>(display.width) *
                static_cast<std::size_t>(display.height));
    for (int y = 0; y < display.height; ++y)
        for (int x = 0; x < display.width; ++x)
            for (int c = 0; c < 3; ++c)
                rgb.push_back(scene(position(x, y, c), (x + 0.5) / display.width,
                                    (y + 0.5) / display.height, c));
    return rgb;
}

Rgb interleaved(const DisplayProfile& display, const ViewMap& map) {
    return filled(display, [&](int x, int y, int c) {
        return viewPosition(display, static_cast<int>(map.view(map.phase(x, y, c))));
    });
}

glm::dvec3 eyeAt(const DisplayProfile& display, double b) {
    const double distance = display.viewingDistanceM;
    return {b * distance * std::tan(display.coneRad / 2), 0, distance};
}

test::ImageView picture(const DisplayProfile& display, const Rgb& rgb) {
    return {rgb, display.width, display.height, 3};
}

/// In the middle of a zone a lens covers sub-pixels of that view only: nothing may differ.
TEST(LookViews, FromTheMiddleOfAZoneThereIsThatViewAlone) {
    for (const char* name : {"slanted-8view-1080p", "barrier-5view"}) {
        const DisplayProfile display = quarter(config::loadDisplay(name));
        const auto optics = displayOptics(display).value();
        const ViewMap map = makeViewMap(display, display.width, display.height);
        const Rgb panel = interleaved(display, map);
        for (int view = 0; view < display.views; ++view) {
            const double b = viewPosition(display, view);
            const Rgb alone = filled(display, [b](int, int, int) { return b; });
            const glm::dvec3 eye = eyeAt(display, b);
            const Rgb seen = look(optics, {}, eye, panel).rgb;
            EXPECT_EQ(seen, look(optics, {}, eye, alone).rgb) << name << " view " << view;
            // Samples 3 to 5 pixels apart stand for their surroundings: 55 dB.
            const auto difference =
                test::compareImages(picture(display, seen), picture(display, alone));
            EXPECT_GT(difference.psnrDb, 40) << name << " view " << view << difference;
        }
    }
}

/// Mean and largest distance of the views that are seen, in views from the eye's place.
struct Spread {
    double mean = 0, most = 0;
};
Spread spreadAt(const DisplayProfile& display, const LightModel& light, double b) {
    const ViewMap map = makeViewMap(display, display.width, display.height);
    const auto optics = displayOptics(display).value();
    Spread spread;
    double sum = 0;
    forSeen(optics, light, eyeAt(display, b), spreadRows(display.height, 30),
            [&](const SeenSubpixel& seen) {
                const auto view = static_cast<int>(map.view(map.phase(seen.x, seen.y, seen.c)));
                const double off = wrapped(viewPosition(display, view) - b) * display.views / 2;
                spread.mean += seen.share * off;
                spread.most = std::max(spread.most, std::abs(off));
                sum += seen.share;
            });
    spread.mean /= sum;
    return spread;
}

/// More views than sub-pixels under a lens: several are seen, evenly about the eye's place. The
/// farthest: half a sub-pixel and half the aperture beside the axis, half a view beside its middle.
TEST(LookViews, BetweenViewsTheirMeanIsTheEyesPlace) {
    const DisplayProfile portrait = quarter(config::loadDisplay("looking-glass-portrait"));
    constexpr double kPortraitPeriod = 3 * 324 / 52.0466; // DPI over lenses per inch along a row
    for (const double aperture : {0.0, 0.05, 0.2})
        for (const double b : {-0.75, -0.31, 0.0, 0.2, 0.77}) {
            const Spread spread = spreadAt(portrait, {aperture, 0}, b);
            EXPECT_LT(std::abs(spread.mean), 0.1) << aperture << ' ' << b;
            EXPECT_LT(spread.most, 48 / (2 * kPortraitPeriod) + 48 * aperture / 2 + 0.51);
        }
    // Every second row has no sub-pixel in its middle: as wide as a sub-pixel, the aperture shows
    // halves of both neighbours.
    const DisplayProfile table = sixViewTable();
    for (int view = 0; view < 6; ++view) {
        const Spread spread = spreadAt(table, {1.0 / 3, 0}, viewPosition(table, view));
        EXPECT_LT(std::abs(spread.mean), 0.1) << view;
        EXPECT_LT(spread.most, 6 / (2 * 3.0) + 6 / (2 * 3.0) + 0.51);
        EXPECT_GT(spread.most, 0.9);
    }
}

TEST(LookViews, PortraitShowsTheEyesOwnPicture) {
    const DisplayProfile display = quarter(config::loadDisplay("looking-glass-portrait"));
    const auto optics = displayOptics(display).value();
    const ViewMap map = makeViewMap(display, display.width, display.height);
    const Rgb panel = interleaved(display, map);
    for (const double b : {-0.8, 0.013, 0.6}) {
        const Rgb seen = look(optics, {}, eyeAt(display, b), panel).rgb;
        const Rgb expected = filled(display, [b](int, int, int) { return b; });
        const auto difference =
            test::compareImages(picture(display, seen), picture(display, expected));
        // 42 to 43 dB; the worst samples are at the border, where the neighbours lie to one side.
        EXPECT_GT(difference.psnrDb, 40) << difference;
    }
}

} // namespace
} // namespace autostereo::calib

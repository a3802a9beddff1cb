// The light model of `look`: what counts as seen, and how it adds up.

#include "calib/look.hpp"
#include "calib/srgb.hpp"
#include "tests/unit/calib/seen_light.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace autostereo::calib {
namespace {

DisplayProfile slanted(const VanBerkelLens& lens, int views) {
    DisplayProfile display;
    display.width = 240;
    display.height = 120;
    display.widthM = 0.06;
    display.viewingDistanceM = 0.5;
    display.coneRad = 0.5;
    display.views = views;
    display.order = ViewOrder::RightToLeft;
    display.law = lens;
    display.optics.kind = Optics::Kind::Lens;
    return display;
}

DisplayOptics eightViews() { return displayOptics(slanted({8, 1, 0}, 8)).value(); }

glm::dvec3 eyeAt(double b) { return {b * 0.5 * std::tan(0.25), 0, 0.5}; }

std::vector<double> row(const DisplayOptics& optics, const LightModel& light, const glm::dvec3& eye,
                        int y) {
    std::vector<double> shares(3 * static_cast<std::size_t>(optics.subpixels.width));
    seenShares(optics, light, eye, y, shares);
    return shares;
}

using Rgb = std::vector<std::uint8_t>;

Rgb uniform(const DisplayOptics& optics, std::array<std::uint8_t, 3> color) {
    Rgb rgb;
    for (int i = 0; i < optics.subpixels.width * optics.subpixels.height; ++i)
        rgb.insert(rgb.end(), color.begin(), color.end());
    return rgb;
}

/// Also where an axis lies exactly between two sub-pixels, as from b = 0 and +-1/4.
TEST(SeenShares, ALineIsInOneSubpixelOfEachLens) {
    const DisplayOptics optics = eightViews();
    for (const double b : {-0.875, -0.25, -0.1, 0.0, 0.25, 0.3, 0.5, 0.9})
        for (int y = 0; y < optics.subpixels.height; ++y) {
            const auto shares = row(optics, {}, eyeAt(b), y);
            for (std::size_t first = 0; first + 8 <= shares.size(); ++first)
                ASSERT_EQ(std::accumulate(shares.begin() + static_cast<std::ptrdiff_t>(first),
                                          shares.begin() + static_cast<std::ptrdiff_t>(first) + 8,
                                          0.0),
                          1)
                    << b << ' ' << y << ' ' << first;
        }
}

/// From nearer and beside, lenses cover another number of sub-pixels: as many as axes are crossed.
TEST(SeenShares, ALineIsInOneSubpixelFromAnywhere) {
    const DisplayOptics optics = displayOptics(slanted({7.3, 0.43, 0.2}, 20)).value();
    const auto& layout = optics.subpixels;
    for (const glm::dvec3& eye : {glm::dvec3{0.1, 0.2, 0.3}, glm::dvec3{-0.2, 0.1, 1.3}})
        for (int y = 0; y < layout.height; y += 7) {
            const auto shares = row(optics, {}, eye, y);
            const double half = layout.pixelM / 6;
            const glm::dvec2 left = layout.position(0, y, 0) - glm::dvec2{half, 0};
            const glm::dvec2 right = layout.position(layout.width - 1, y, 2) + glm::dvec2{half, 0};
            const double crossed = std::floor(optics.lenses.coordinate(eye, right)) -
                                   std::floor(optics.lenses.coordinate(eye, left));
            EXPECT_EQ(std::accumulate(shares.begin(), shares.end(), 0.0), crossed) << y;
        }
}

/// Lenses are eight sub-pixels wide, so an aperture of a cycles shows 8 a sub-pixels of each.
TEST(SeenShares, AnApertureShowsItsShareOfThePanel) {
    const DisplayOptics optics = eightViews();
    for (const double aperture : {0.01, 0.125, 0.3, 0.75, 1.0})
        for (const double b : {-0.3, 0.0, 0.125}) {
            const auto shares = row(optics, {aperture, 0}, eyeAt(b), 5);
            for (std::size_t first = 0; first + 8 <= shares.size(); first += 8)
                EXPECT_NEAR(std::accumulate(shares.begin() + static_cast<std::ptrdiff_t>(first),
                                            shares.begin() + static_cast<std::ptrdiff_t>(first) + 8,
                                            0.0),
                            8 * aperture, 1e-9);
            for (const double share : shares)
                EXPECT_TRUE(share >= 0 && share <= 1);
        }
    // From the middle of a zone a quarter of a lens is one sub-pixel and half of either neighbour.
    const auto shares = row(optics, {0.25, 0}, eyeAt(0.125), 0);
    const auto most = std::max_element(shares.begin() + 8, shares.begin() + 16);
    EXPECT_NEAR(*most, 1, 1e-9);
    EXPECT_NEAR(*(most - 1), 0.5, 1e-9);
    EXPECT_NEAR(*(most + 1), 0.5, 1e-9);
    EXPECT_NEAR(*(most + 2), 0, 1e-9);
}

/// Neighbours by place, so in a BGR stripe B comes first.
TEST(SeenShares, CrosstalkGoesToEitherNeighbour) {
    for (const bool bgr : {false, true}) {
        const DisplayOptics optics = displayOptics(slanted({8, 1, 0, bgr}, 8)).value();
        const auto place = [bgr](std::size_t k) { return bgr ? 3 * (k / 3) + 2 - k % 3 : k; };
        const auto sharp = row(optics, {}, eyeAt(0.125), 7);
        const auto leaking = row(optics, {0, 0.1}, eyeAt(0.125), 7);
        for (std::size_t k = 1; k + 1 < sharp.size(); ++k)
            EXPECT_NEAR(leaking[place(k)],
                        0.8 * sharp[place(k)] + 0.1 * (sharp[place(k - 1)] + sharp[place(k + 1)]),
                        1e-15)
                << k;
        EXPECT_NEAR(std::accumulate(leaking.begin(), leaking.end(), 0.0),
                    std::accumulate(sharp.begin(), sharp.end(), 0.0), 0.2)
            << "but at the ends";
    }
}

TEST(Look, AUniformPanelStaysAsItIs) {
    // Vertical lenses show some columns no light of a colour for three lenses on.
    for (const VanBerkelLens& lens : {VanBerkelLens{8, 1, 0}, VanBerkelLens{18.7, -0.42, 3},
                                      VanBerkelLens{8, 0, 0}, VanBerkelLens{31, 0.01, 0}}) {
        const DisplayOptics optics = displayOptics(slanted(lens, 8)).value();
        for (const LightModel& light :
             {LightModel{}, LightModel{0.2, 0}, LightModel{1, 0}, LightModel{0.05, 0.15}})
            for (const std::array<std::uint8_t, 3> color :
                 {std::array<std::uint8_t, 3>{255, 255, 255}, {0, 0, 0}, {1, 77, 200}}) {
                const Rgb panel = uniform(optics, color);
                EXPECT_EQ(look(optics, light, {0.02, 0.03, 0.5}, panel).rgb, panel)
                    << lens.subpixelsPerLens << ' ' << light.aperture;
            }
    }
}

TEST(Look, LightAddsUpLinearly) {
    // Sub-pixels black and white in turn, all of them seen: half the light is level 188 of sRGB.
    const DisplayOptics optics = eightViews();
    Rgb panel = uniform(optics, {0, 0, 0});
    for (std::size_t i = 0; i < panel.size(); ++i)
        panel[i] = (i / 3 + i / 720) % 2 == 0 ? 255 : 0;
    const EyePicture seen = look(optics, {1, 0}, {0, 0, 0.5}, panel);
    EXPECT_EQ(seen.lit, panel.size());
    EXPECT_NEAR(seen.meanShare, 1, 1e-9);
    // The tent is three pixels wide, of which the middle one weighs as much as its neighbours.
    for (std::size_t i = 720 * 10; i < panel.size() - 720 * 10; ++i)
        if (i % 720 > 30 && i % 720 < 690) {
            ASSERT_NEAR(seen.rgb[i], 188, 8) << i;
        }
}

TEST(Look, ColorsStayApart) {
    const DisplayOptics optics = eightViews();
    const Rgb seen = look(optics, {0.2, 0.1}, {0.01, 0, 0.5}, uniform(optics, {255, 0, 0})).rgb;
    EXPECT_EQ(seen, uniform(optics, {255, 0, 0}));
}

TEST(Look, APanelUpsideDownIsSeenUpright) {
    LookingGlassCalibration unit;
    unit.pitch = 50;
    unit.slope = -7;
    unit.dpi = 240 / (0.06 / 0.0254);
    unit.screenWidth = 240;
    unit.screenHeight = 120;
    unit.flipImageY = true;
    auto display = slanted({8, 1, 0}, 8);
    display.law = unit;
    const DisplayOptics optics = displayOptics(display).value();
    Rgb panel = uniform(optics, {0, 0, 0});
    std::fill(panel.begin(), panel.begin() + static_cast<std::ptrdiff_t>(panel.size() / 2),
              std::uint8_t{255}); // the first rows that are sent, the lowest that are seen
    const Rgb seen = look(optics, {}, {0, 0, 0.5}, panel).rgb;
    EXPECT_EQ(seen.front(), 0);
    EXPECT_EQ(seen.back(), 255);
}

TEST(Look, RefusesOtherSizesAndEyesBehind) {
    const DisplayOptics optics = eightViews();
    const Rgb panel = uniform(optics, {9, 9, 9});
    EXPECT_THROW((void)look(optics, {}, {0, 0, 0.5}, std::span(panel).first(30)),
                 std::invalid_argument);
    EXPECT_THROW((void)look(optics, {}, {0, 0, optics.lenses.gapM}, panel), std::invalid_argument);
    EXPECT_THROW((void)look(optics, {}, {0, 0, -1}, panel), std::invalid_argument);
}

TEST(Srgb, EveryLevelComesBack) {
    const Srgb srgb;
    for (int level = 0; level < 256; ++level)
        EXPECT_EQ(srgb.level(srgb.light(static_cast<std::uint8_t>(level))), level);
    EXPECT_EQ(srgb.level(0.5), 188);
    EXPECT_EQ(srgb.level(-1), 0);
    EXPECT_EQ(srgb.level(2), 255);
    EXPECT_NEAR(srgb.light(128), 0.2158605, 1e-6);
}

} // namespace
} // namespace autostereo::calib

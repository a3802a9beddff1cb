// Every kind of panel map: what the GPU shows in each sub-pixel is what the host says.

#include "tests/gl/numbered_views.hpp"
#include "tests/support/gl_fixture.hpp"

#include <array>
#include <cmath>

namespace autostereo::test {
namespace {

class InterleaverGlTest : public GlTest {
  protected:
    static constexpr int kWidth = 331, kHeight = 203;

    static calib::DisplayProfile display(calib::DisplayLaw law, int views) {
        calib::DisplayProfile display;
        display.width = kWidth;
        display.height = kHeight;
        display.views = views;
        display.law = std::move(law);
        return display;
    }
    static std::size_t wrongOf(const calib::DisplayProfile& display) {
        const calib::ViewMap map = calib::makeViewMap(display, kWidth, kHeight);
        return differences(interleaved(map, kWidth, kHeight, display.views, {}),
                           [&](int x, int y, int c) { return levelOf(map, x, y, c); });
    }
};

TEST_F(InterleaverGlTest, CellsOfEveryPattern) {
    using calib::CellPattern;
    for (const auto pattern : {CellPattern::Single, CellPattern::Checkerboard, CellPattern::Columns,
                               CellPattern::Staircase, CellPattern::Rows, CellPattern::FourRows}) {
        calib::LinearPhase law;
        law.perColumn = 0.1234;
        law.perRow = -0.0567;
        law.pattern = pattern;
        law.channels.clear();
        for (int cell = 0; cell < calib::cellCount(pattern); ++cell)
            law.channels.push_back({0.05 * cell, 0.3 - 0.07 * cell, 0.7 + 0.011 * cell});
        EXPECT_EQ(wrongOf(display(law, 48)), 0U) << static_cast<int>(pattern);
    }
}

TEST_F(InterleaverGlTest, PhaseGrid) {
    calib::LinearPhase law;
    law.perColumn = 0.31;
    law.perRow = 0.017;
    law.channels = {{0, 0.1, 0.2}};
    law.grid.columns = 5;
    law.grid.rows = 3;
    for (int node = 0; node < 15; ++node)
        law.grid.cycles.push_back(0.4 * std::sin(1.7 * node));
    EXPECT_EQ(wrongOf(display(law, 100)), 0U);
    law.grid = {1, 1, {0.25}};
    EXPECT_EQ(wrongOf(display(law, 100)), 0U);
}

TEST_F(InterleaverGlTest, LutAndRemap) {
    auto phases = std::make_shared<std::vector<std::uint32_t>>();
    for (std::uint32_t i = 0; i < 3U * kWidth * kHeight; ++i)
        phases->push_back(i * 2654435761U);
    calib::DisplayProfile masked = display(calib::ViewLut{kWidth, kHeight, phases}, 2);
    masked.remap = {0, 0, 1, 1, calib::DisplayProfile::kBlack};
    EXPECT_EQ(wrongOf(masked), 0U);
}

TEST_F(InterleaverGlTest, TurnedOrder) {
    calib::LinearPhase law;
    law.perColumn = 0.19;
    law.perRow = 0.07;
    calib::DisplayProfile turned = display(law, 9);
    turned.order = calib::ViewOrder::RightToLeft;
    EXPECT_EQ(wrongOf(turned), 0U);
}

TEST_F(InterleaverGlTest, UpsideDownTurnsThePictureAndNotThePhases) {
    calib::LinearPhase law;
    law.perColumn = 0.19;
    law.perRow = 0.07;
    calib::ViewMap map = calib::makeViewMap(display(law, 9), kWidth, kHeight);
    map.upsideDown = true;
    EXPECT_EQ(differences(interleaved(map, kWidth, kHeight, 9, {}),
                          [&](int x, int y, int c) { return levelOf(map, x, y, c); }),
              0U);

    // One view, whose tile is dark below and bright above.
    gpu::Atlas atlas({1, {1, 1, 1, 2}});
    const std::array<std::uint8_t, 8> texels{40, 40, 40, 40, 200, 200, 200, 200};
    glTextureSubImage2D(atlas.color().name(), 0, 0, 0, 1, 2, GL_RGBA, GL_UNSIGNED_BYTE,
                        texels.data());
    map = calib::makeViewMap(display(law, 1), kWidth, kHeight);
    const auto topOf = [&](bool upsideDown) {
        map.upsideDown = upsideDown;
        return interleavedFrom(atlas, map, kWidth, kHeight, {}).pixels.front();
    };
    EXPECT_EQ(topOf(false), 200);
    EXPECT_EQ(topOf(true), 40);
}

TEST_F(InterleaverGlTest, TilesLieAsTheirKindSays) {
    // 331 x 203 in 2 x 3 tiles of 165 x 67: one column and two rows are left over.
    const auto viewAt = [](int x, int y, bool topFirst) {
        const int row = topFirst ? y / 67 : (kHeight - 1 - y) / 67;
        return x / 165 >= 2 || row >= 3 ? -1 : row * 2 + x / 165;
    };
    for (const bool topFirst : {true, false}) {
        const auto image = interleaved(calib::TileFrame{2, 3, topFirst, false}, kWidth, kHeight, 6,
                                       {gpu::TileFilter::Linear, gpu::ViewFilter::Nearest, 0});
        EXPECT_EQ(
            differences(image, [&](int x, int y, int) { return levelOf(viewAt(x, y, topFirst)); }),
            0U);
    }
    const auto swapped = interleaved(calib::TileFrame{2, 1, true, true}, kWidth, kHeight, 2, {});
    EXPECT_EQ(differences(swapped,
                          [](int x, int, int) { return x >= 330 ? 0 : levelOf(x < 165 ? 1 : 0); }),
              0U);
}

TEST_F(InterleaverGlTest, BlendGoesOverToTheNextViewAndNeverWraps) {
    calib::LinearPhase law;
    law.perColumn = 1.0 / kWidth; // one lens over the panel: phase = share of the width
    const auto display9 = display(law, 9);
    const calib::ViewMap map = calib::makeViewMap(display9, kWidth, kHeight);
    const auto image =
        interleaved(map, kWidth, kHeight, 9, {gpu::TileFilter::Linear, gpu::ViewFilter::Blend, 0});
    for (int x = 0; x < kWidth; ++x) {
        const double position = 9.0 * x / kWidth;
        const int view = static_cast<int>(position), next = std::min(view + 1, 8);
        const double level = levelOf(view) + (position - view) * (levelOf(next) - levelOf(view));
        EXPECT_NEAR(image.pixels[3 * static_cast<std::size_t>(x)], level, 0.51) << x;
    }
}

TEST_F(InterleaverGlTest, FringeFadesTheBorder) {
    const auto image =
        interleaved(calib::makeViewMap(display(calib::LinearPhase{}, 1), kWidth, kHeight), kWidth,
                    kHeight, 100, {gpu::TileFilter::Linear, {}, 10});
    const auto levelAt = [&](int x, int y) {
        return image.pixels[3 * static_cast<std::size_t>(y * kWidth + x)];
    };
    EXPECT_EQ(levelAt(100, 100), levelOf(0));
    EXPECT_LT(levelAt(0, 100), levelOf(0));
    EXPECT_LT(levelAt(100, kHeight - 1), levelOf(0));
}

TEST_F(InterleaverGlTest, WaveformRampsAndItsLobeTakesAway) {
    calib::LinearPhase law;
    law.perColumn = 1.0 / kWidth;
    calib::BandMap map;
    map.eyes = {calib::phaseTables(law, kWidth, kHeight)};
    map.waveform = calib::Waveform{{{{0.1, 0.3, 0.6, 0.8}, {0.1, 0.3, 0.6, 0.8}, {0, 0, 1, 1}}}, 0};
    const auto image = interleaved(map, kWidth, kHeight, 100, {});
    for (int x = 0; x < kWidth; ++x) {
        const double t = static_cast<double>(x) / kWidth;
        const double share = std::clamp(std::min((t - 0.1) / 0.2, (0.8 - t) / 0.2), 0.0, 1.0);
        const std::size_t at = 3 * static_cast<std::size_t>(x);
        EXPECT_NEAR(image.pixels[at], share * levelOf(0), 0.51) << x;
        EXPECT_EQ(image.pixels[at + 2], levelOf(0)) << x;
    }
}

} // namespace
} // namespace autostereo::test

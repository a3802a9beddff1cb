// Cameras mounted in any way, the panel as a mirror, and a backdrop in place of what is far.

#include "tests/replay/pictures.hpp"
#include "tests/replay/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace autostereo::test {
namespace {

constexpr int kPictureSide = 96; ///< of square pictures: turned, they cover the same

/// Blocks of colours, none like its neighbours, in front of which nobody can mistake up or left.
Rgb wallpaper(int x, int y) {
    const unsigned block = static_cast<unsigned>(x / 6 * 31 + y / 6 * 17);
    const auto level = [&](unsigned factor) {
        return static_cast<std::uint8_t>(40 + block * factor % 180);
    };
    return {level(37), level(53), level(71)};
}

/// A near pane left of and above the middle.
bool isPane(int x, int y) { return x >= 24 && x < 48 && y >= 30 && y < 54; }
int paneDepth(int x, int y) { return isPane(x, y) ? 1200 : 2000; }

/// Where a camera that is mounted so has the scene's pixel (x, y) in its picture: the inverse, of
/// its own pixel.
struct Mounting {
    const char* name;
    const char* config;
    std::pair<int, int> (*scene)(int x, int y);
};
constexpr int kLast = kPictureSide - 1;
constexpr Mounting kMountings[] = {{"a quarter turn", "[framing]\nmounting_deg = 90\n",
                                    [](int x, int y) {
                                        return std::pair{kLast - y, x};
                                    }},
                                   {"upside down", "[framing]\nmounting_deg = 180\n",
                                    [](int x, int y) {
                                        return std::pair{kLast - x, kLast - y};
                                    }},
                                   {"three quarter turns", "[framing]\nmounting_deg = 270\n",
                                    [](int x, int y) {
                                        return std::pair{y, kLast - x};
                                    }},
                                   {"a mirror", "[framing]\nmirror = true\n",
                                    [](int x, int y) {
                                        return std::pair{kLast - x, y};
                                    }},
                                   {"a mirror and a quarter turn",
                                    "[framing]\nmirror = true\nmounting_deg = 90\n",
                                    [](int x, int y) {
                                        return std::pair{y, x};
                                    }}};

class FramingReplay : public testing::Test {
  protected:
    /// View `view` of a scene, each pixel's colour and millimetres.
    template<class Color, class Depth>
    ColorPicture view(int number, const std::string& config, Color color, Depth depth) {
        const std::string input =
            "rgbd:" + writeColor(folder / "c.png", kPictureSide, kPictureSide, color) + "," +
            writeDepth(folder / "d.png", kPictureSide, kPictureSide, depth) + "," +
            cameraFile(folder, kPictureSide, kPictureSide);
        EXPECT_TRUE(succeeded(runProgram(calling(
            {"render", "--input", input, "--display", smallDisplay(folder), "--config",
             folder.file("config.toml", config), "--as", "views", "--output", folder / "views"}))));
        return readColor(folder / ("views/view_0" + std::to_string(number) + ".png"));
    }
    TempFolder folder;
};

/// Share of pixels more than 16 levels apart in any channel.
double shareOff(const ColorPicture& a, const ColorPicture& b) {
    std::size_t off = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        int most = 0;
        for (std::size_t c = i; c < i + 3; ++c)
            most = std::max(most, std::abs(int{a.rgb[c]} - int{b.rgb[c]}));
        off += most > 16 ? 1 : 0;
    }
    return 3 * static_cast<double>(off) / static_cast<double>(a.rgb.size());
}

/// The cells' diagonals and the order of rows and columns turn with the camera: at the pane's edges
/// a pixel may fall to the other surface (measured: 0.8 %).
TEST_F(FramingReplay, HoweverMountedThePictureIsTheSame) {
    for (const int number : {0, kSmallViews - 1}) {
        const ColorPicture upright = view(number, "", wallpaper, paneDepth);
        for (const Mounting& mounting : kMountings) {
            const auto color = [&](int x, int y) {
                const auto [sx, sy] = mounting.scene(x, y);
                return wallpaper(sx, sy);
            };
            const auto depth = [&](int x, int y) {
                const auto [sx, sy] = mounting.scene(x, y);
                return paneDepth(sx, sy);
            };
            const ColorPicture turned = view(number, mounting.config, color, depth);
            EXPECT_LE(shareOff(turned, upright), 0.02) << mounting.name << ", view " << number;
            EXPECT_GT(shareOff(view(number, "", color, depth), upright), 0.3)
                << mounting.name << ": the test compares nothing";
        }
    }
}

/// Views look past the panel's edges: there the scene goes on, no column of it is repeated. The
/// wall stands at the budget's end, and its brightness grows by at least one level in three
/// columns.
TEST_F(FramingReplay, NoBorderColumnIsRepeated) {
    const auto ramp = [](int x, int y) {
        const auto level = static_cast<std::uint8_t>(20 + x + y);
        return Rgb{level, level, level};
    };
    const std::string near = "[depth]\nfocus_m = 1\n";
    for (const char* config :
         {"", "[framing]\nzoom = 1.5\npan = [1, -1]\n", "[framing]\nzoom = 1.5\npan = [-1, 1]\n",
          "[framing]\nmounting_deg = 90\nmirror = true\n"})
        for (const int number : {0, kSmallViews - 1}) {
            const ColorPicture picture =
                view(number, near + config, ramp, [](int, int) { return 4000; });
            for (const int edge : {0, picture.width - 4})
                for (int y = 0; y < picture.height; ++y)
                    ASSERT_GE(picture.at(edge + 3, y)[1] - picture.at(edge, y)[1], 1)
                        << config << number << " at " << edge << ", " << y;
        }
}

struct Shares {
    double visitor = 0, backdrop = 0, wall = 0;
};

/// A blue visitor before a red wall, with a green backdrop.
Shares sharesOf(const ColorPicture& picture) {
    Shares shares;
    const double pixel = 1.0 / (picture.width * picture.height);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const auto* rgb = picture.at(x, y);
            if (rgb[0] > 60) shares.wall += pixel;
            if (rgb[1] > 180 && rgb[2] < 40) shares.backdrop += pixel;
            if (rgb[2] > 180 && rgb[1] < 40) shares.visitor += pixel;
        }
    return shares;
}

TEST_F(FramingReplay, WhatIsFarGivesWayToTheBackdrop) {
    const auto color = [](int x, int y) { return isPane(x, y) ? Rgb{0, 0, 220} : Rgb{220, 0, 0}; };
    const auto depth = [](int x, int y) { return isPane(x, y) ? 1200 : y > 70 ? 0 : 3000; };
    writeColor(folder / "green.png", 7, 5, [](int, int) { return Rgb{0, 220, 0}; });
    const std::string cut = "[framing]\nfar_cut_m = 2\n";
    for (const int number : {0, 3, kSmallViews - 1}) {
        const Shares all = sharesOf(view(number, "", color, depth));
        EXPECT_EQ(all.backdrop, 0);
        EXPECT_GT(all.wall, 0.5);
        for (const char* backdrop :
             {"backdrop_color = [0, 0.86, 0]\n", "backdrop_picture = 'green.png'\n"}) {
            const Shares shares = sharesOf(view(number, cut + backdrop, color, depth));
            EXPECT_LE(shares.wall, 0.01) << number << backdrop;
            EXPECT_NEAR(shares.visitor, all.visitor, 0.02);
            EXPECT_GE(shares.visitor + shares.backdrop, 0.97);
        }
    }
}

TEST_F(FramingReplay, ThePictureOfABackdropStandsUpright) {
    writeColor(folder / "quarters.png", 40, 30, [](int x, int y) {
        return x < 20 ? Rgb{static_cast<std::uint8_t>(y < 15 ? 250 : 120), 0, 0}
                      : Rgb{0, 0, static_cast<std::uint8_t>(y < 15 ? 250 : 120)};
    });
    const ColorPicture shown = view(
        3, "[framing]\nfar_cut_m = 1\nmirror = true\nbackdrop_picture = 'quarters.png'\n",
        [](int, int) {
            return Rgb{0, 99, 0};
        },
        [](int, int) { return 3000; });
    const auto expectColor = [&](int x, int y, int red, int blue) {
        EXPECT_NEAR(shown.at(x, y)[0], red, 3) << x << ' ' << y;
        EXPECT_NEAR(shown.at(x, y)[2], blue, 3) << x << ' ' << y;
        EXPECT_EQ(shown.at(x, y)[1], 0);
    };
    expectColor(10, 10, 250, 0);
    expectColor(10, 80, 120, 0);
    expectColor(150, 10, 0, 250);
    expectColor(150, 80, 0, 120);
}

} // namespace
} // namespace autostereo::test

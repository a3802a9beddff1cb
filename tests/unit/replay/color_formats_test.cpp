#include "devices/replay/color_formats.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <vector>

namespace autostereo {
namespace {

std::vector<std::byte> bytes(std::initializer_list<int> values) {
    std::vector<std::byte> result;
    for (const int value : values)
        result.push_back(static_cast<std::byte>(value));
    return result;
}

void expectPixel(std::span<const std::byte> rgba, std::array<int, 3> rgb) {
    for (std::size_t c = 0; c < 3; ++c) // 1: the table of 75 % bars is itself rounded
        EXPECT_NEAR(std::to_integer<int>(rgba[c]), rgb[c], 1) << "channel " << c;
    EXPECT_EQ(rgba[3], std::byte{255});
}

TEST(ColorFormats, yuy2IsStudioRangeBt601) {
    // White, black; then the 75 % bars red and blue of ITU-R BT.801.
    std::vector<std::byte> rgba(16);
    devices::yuy2ToRgba(bytes({235, 128, 16, 128, 65, 100, 65, 212}), rgba);
    expectPixel(std::span(rgba).subspan(0, 4), {255, 255, 255});
    expectPixel(std::span(rgba).subspan(4, 4), {0, 0, 0});
    expectPixel(std::span(rgba).subspan(8, 4), {191, 0, 0});
    devices::yuy2ToRgba(bytes({35, 212, 35, 114}), std::span(rgba).first(8));
    expectPixel(std::span(rgba).first(4), {0, 0, 191});
}

TEST(ColorFormats, nv12SharesOneColourAmongFourPixels) {
    // 4x2: the left block red, the right one blue.
    std::vector<std::byte> rgba(4 * 2 * 4);
    devices::nv12ToRgba(bytes({65, 65, 35, 35, 65, 65, 35, 35, 100, 212, 212, 114}), 4, 2, rgba);
    for (const std::size_t pixel : {0U, 1U, 4U, 5U})
        expectPixel(std::span(rgba).subspan(pixel * 4, 4), {191, 0, 0});
    for (const std::size_t pixel : {2U, 3U, 6U, 7U})
        expectPixel(std::span(rgba).subspan(pixel * 4, 4), {0, 0, 191});
}

TEST(ColorFormats, bgraIsTurnedRound) {
    std::vector<std::byte> rgba(4);
    devices::bgraToRgba(bytes({1, 2, 3, 0}), rgba);
    EXPECT_EQ(rgba, bytes({3, 2, 1, 255}));
}

} // namespace
} // namespace autostereo

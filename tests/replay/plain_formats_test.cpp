// render --as sbs, anaglyph and 2d-plus-depth: what other monitors and players take.

#include "tests/replay/pictures.hpp"
#include "tests/replay/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace autostereo::test {
namespace {

class PlainFormats : public ::testing::Test {
  protected:
    ColorPicture render(std::vector<std::string> words) {
        std::vector<std::string> all{"render",
                                     "--input",
                                     "sim:room?depth=176x144&color=320x180",
                                     "--display",
                                     kDisplay,
                                     "--output",
                                     folder / "picture.png"};
        all.insert(all.end(), words.begin(), words.end());
        EXPECT_TRUE(succeeded(runProgram(calling(all))));
        return readColor(folder / "picture.png");
    }
    static constexpr const char* kDisplay = "slanted-8view-1080p"; // viewed from 1 m
    TempFolder folder;
};

/// Columns `left` on, and of every pixel one channel three times.
ColorPicture part(const ColorPicture& picture, int left, int width, int channel) {
    ColorPicture part{width, picture.height, {}};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < width; ++x)
            part.rgb.insert(part.rgb.end(), 3, picture.at(left + x, y)[channel]);
    return part;
}

TEST_F(PlainFormats, SideBySideHasTheLeftEyeOnTheLeft) {
    const ColorPicture both = render({"--as", "sbs"});
    ASSERT_EQ(both.width, 1920);
    ASSERT_EQ(both.height, 1080);
    const ColorPicture left = part(both, 0, 960, 1), right = part(both, 960, 960, 1);
    EXPECT_LT(shiftOf({40, 500, 90, 300}, left, right, 20), -2) << "the plant, before the panel";
    EXPECT_EQ(shiftOf({290, 200, 230, 310}, left, right, 20), 0) << "the painting, in its plane";
}

TEST_F(PlainFormats, AnaglyphIsLeftInRedAndRightInTheRest) {
    const ColorPicture both = render({"--as", "sbs"}), mixed = render({"--as", "anaglyph"});
    for (const int c : {0, 1, 2}) {
        std::array<double, 2> apart{}; // from left and right half, which have half the width
        for (int y = 0; y < 1080; y += 3)
            for (int x = 0; x < 1920; x += 3)
                for (const int half : {0, 1})
                    apart[static_cast<std::size_t>(half)] +=
                        std::abs(mixed.at(x, y)[c] - both.at(960 * half + x / 2, y)[c]);
        const bool red = c == 0;
        EXPECT_LT(red ? apart[0] : apart[1], (red ? apart[1] : apart[0]) / 2) << c;
    }
}

/// Bits of the header: the blue channel's topmost bit of every other pixel of the first row,
/// most significant first.
TEST_F(PlainFormats, DepthFrameHasItsHeaderAndGreyOnTheRight) {
    const ColorPicture frame = render({"--as", "2d-plus-depth"});
    std::array<int, 2> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i)
        for (int bit = 0; bit < 8; ++bit)
            bytes[i] = bytes[i] << 1 | frame.at(2 * (8 * static_cast<int>(i) + bit), 0)[2] >> 7;
    EXPECT_EQ(bytes[0], 0xf1) << "the header's first byte";
    int least = 255, most = 0;
    for (int y = 8; y < frame.height; y += 5)
        for (int x = frame.width / 2; x < frame.width; x += 5) {
            const auto* grey = frame.at(x, y);
            ASSERT_TRUE(grey[0] == grey[1] && grey[1] == grey[2]) << x << ' ' << y;
            least = std::min<int>(least, grey[0]);
            most = std::max<int>(most, grey[0]);
        }
    EXPECT_LT(least, 128) << "the back wall lies behind the panel";
    EXPECT_GT(most, 128) << "the front objects stand before it";
}

} // namespace
} // namespace autostereo::test

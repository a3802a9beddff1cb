#include "calib/depth_frame_header.hpp"
#include "calib/flat_panel.hpp"
#include "calib/glyphs.hpp"
#include "calib/message_picture.hpp"
#include "config/load.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace autostereo::calib {
namespace {

std::string drawn(char32_t letter) {
    const Glyph glyph = glyphOf(letter);
    std::string text;
    for (int row = 0; row < Glyph::kHeight; ++row) {
        for (int column = 0; column < Glyph::kWidth; ++column)
            text += glyph.has(column, row) ? '#' : '.';
        text += '\n';
    }
    return text;
}

TEST(Glyphs, StandUprightAndTheRightWayRound) {
    EXPECT_EQ(drawn(U'F'), ".....\n.....\n"
                           "#####\n#....\n#....\n####.\n#....\n#....\n#....\n"
                           ".....\n.....\n");
    EXPECT_EQ(drawn(U'\u00C4'), ".....\n.#.#.\n" // A with two dots
                                ".###.\n#...#\n#...#\n#...#\n#####\n#...#\n#...#\n"
                                ".....\n.....\n");
    EXPECT_EQ(drawn(U'\u00E7'), ".....\n.....\n" // c with a cedilla
                                ".....\n.....\n.###.\n#....\n#....\n#...#\n.###.\n"
                                "..#..\n.##..\n");
}

TEST(Glyphs, EveryLetterIsOneOfItsOwn) {
    std::set<std::string> all;
    std::size_t count = 0;
    const auto add = [&](char32_t letter) {
        all.insert(drawn(letter));
        ++count;
    };
    for (char32_t letter = U' '; letter <= U'~'; ++letter)
        add(letter);
    for (const char32_t letter :
         std::u32string(U"ÀÁÂÃÄÅÇÈÉÊËÌÍÎÏÑÒÓÔÕÖÙÚÛÜßàáâãäåçèéêëìíîïñòóôõöùúûüÿ"))
        add(letter);
    add(U'\u4E2D'); // a box
    EXPECT_EQ(all.size(), count);
    EXPECT_EQ(glyphOf(U'\0'), glyphOf(U'\u4E2D'));
}

TEST(Glyphs, Utf8IsReadAndWhatIsNoneIsMarked) {
    EXPECT_EQ(lettersOf("a\xC3\xA4\xE4\xB8\xAD\xF0\x9F\x98\x80"), U"a\u00E4\u4E2D\U0001F600");
    EXPECT_EQ(lettersOf("\xFFx"), U"\uFFFDx");
    EXPECT_EQ(lettersOf("\xC3"), U"\uFFFD");
    EXPECT_EQ(lettersOf("\xC3x"), U"\uFFFDx");
    EXPECT_EQ(lettersOf("\x80"), U"\uFFFD");
}

/// Rows and columns that hold anything as bright as letters.
struct Extent {
    int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
};
Extent inked(const Picture& picture) {
    Extent extent;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            if (picture.pixels[picture.offset(x, y)] < 200) continue;
            extent = {std::min(extent.left, x), std::max(extent.right, x), std::min(extent.top, y),
                      std::max(extent.bottom, y)};
        }
    return extent;
}

TEST(MessagePicture, WordsStandInTheMiddleAsLargeAsFits) {
    for (const auto& [width, height] :
         {std::pair{1920, 1080}, {1536, 2048}, {320, 180}, {64, 40}}) {
        const Picture picture = messagePicture({}, "The cameras do not answer", width, height);
        ASSERT_EQ(picture.pixels.size(), 4U * static_cast<unsigned>(width * height));
        const Extent words = inked(picture);
        ASSERT_GE(words.right, 0) << width;
        EXPECT_GE(words.left, width / 10 - 1) << width;
        EXPECT_LE(words.right, width - width / 10) << width;
        // Centred but for the room that marks and tails have.
        const int cell = std::max(1, std::min(width, height) / 60);
        EXPECT_NEAR(words.left + words.right, width - 1, 2 * cell) << width;
        EXPECT_NEAR(words.top + words.bottom, height - 1, 4 * cell) << width;
        EXPECT_GE(words.bottom - words.top, height / 12) << "to be read from afar";
    }
    EXPECT_EQ(inked(messagePicture({}, "", 320, 180)).right, -1);
}

TEST(MessagePicture, AnyTextFitsOrIsCutButNothingBreaks) {
    for (const std::string& text :
         {std::string(200, 'W'), std::string(200, ' '), std::string("\n\n\n"), std::string(1, '\0'),
          std::string("Donaudampfschifffahrtsgesellschaftskapitaen")})
        for (const auto& [width, height] : {std::pair{1, 1}, {16, 900}, {900, 3}, {320, 180}})
            EXPECT_EQ(messagePicture({}, text, width, height).width, width);
}

TEST(MessagePicture, TheBackgroundKeepsItsShapeAndWordsAreOnShade) {
    Picture white{20, 10, std::vector<std::uint8_t>(800, 250)};
    const Picture plain = messagePicture(white, "", 100, 100);
    EXPECT_EQ(plain.pixels[plain.offset(50, 24)],
              messagePicture({}, "", 100, 100).pixels[plain.offset(50, 24)]);
    EXPECT_EQ(plain.pixels[plain.offset(0, 25)], 250);
    EXPECT_EQ(plain.pixels[plain.offset(99, 74)], 250);
    EXPECT_LT(plain.pixels[plain.offset(50, 75)], 100);
    const Picture said = messagePicture(white, "i", 100, 100);
    EXPECT_EQ(said.pixels[said.offset(2, 50)], 250 * 64 / 255) << "behind the words";
    EXPECT_EQ(said.pixels[said.offset(2, 27)], 250) << "away from them";
}

/// A picture whose pixels are all different.
Picture numbered(int width, int height) {
    Picture picture{width, height, {}};
    for (int i = 0; i < width * height; ++i)
        for (const int level : {i % 256, i / 256 % 256, i * 7 % 256, 255})
            picture.pixels.push_back(static_cast<std::uint8_t>(level));
    return picture;
}

TEST(FlatPanel, OpticsShowEachSubpixelItsOwnPlace) {
    for (const char* name : {"slanted-8view-1080p", "personal-varrier-30", "generic-row",
                             "generic-anaglyph", "preview"}) {
        const DisplayProfile display = config::loadDisplay(name);
        const int width = 96, height = 54;
        const Picture picture = numbered(width, height);
        EXPECT_EQ(flatPanel(picture, panelMap(display, width, height), display.views), picture)
            << name;
    }
}

TEST(FlatPanel, HalfFramesAndQuiltsHaveItInEveryTile) {
    const Picture picture = numbered(64, 32);
    for (const bool topFirst : {true, false}) {
        const Picture panel = flatPanel(picture, TileFrame{2, 2, topFirst, false}, 3);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 64; ++x) {
                const int view = (topFirst ? y / 16 : 1 - y / 16) * 2 + x / 32;
                const int u = x % 32 * 2, v = y % 16 * 2;
                const auto level = [&](int a, int b) {
                    return static_cast<int>(picture.pixels[picture.offset(u + a, v + b) + 2]);
                };
                const int mean = (level(0, 0) + level(1, 0) + level(0, 1) + level(1, 1) + 2) / 4;
                ASSERT_EQ(panel.pixels[panel.offset(x, y) + 2], view < 3 ? mean : 0)
                    << x << ' ' << y;
            }
    }
}

TEST(FlatPanel, DepthFramesSayInThePanelsPlane) {
    DepthFrame frame;
    frame.screenLevel = 128;
    const Picture panel = flatPanel(numbered(640, 8), frame, 1);
    EXPECT_EQ(panel.pixels[panel.offset(320, 3)], 128);
    EXPECT_EQ(panel.pixels[panel.offset(639, 7) + 2], 128);
    const auto header = depthFrameHeaderRow(frame);
    for (int x = 0; x < 256; ++x)
        ASSERT_EQ(panel.pixels[panel.offset(x, 0) + 2], header[static_cast<std::size_t>(x)]);
}

TEST(FlatPanel, PanelsThatScanUpwardsGetTheirRowsTurned) {
    const Picture picture = numbered(8, 5);
    ViewMap map;
    map.upsideDown = true;
    const Picture panel = flatPanel(picture, map, 1);
    for (int x = 0; x < 8; ++x)
        EXPECT_EQ(panel.pixels[panel.offset(x, 0) + 2], picture.pixels[picture.offset(x, 4) + 2]);
}

} // namespace
} // namespace autostereo::calib

#include "devices/replay/image_files.hpp"
#include "tests/support/data.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/replay/playing.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace autostereo {
namespace {

using devices::ImageFormat;
using devices::ImageHeader;
using devices::ImageReader;

std::vector<std::byte> noise(const ImageHeader& header) {
    std::vector<std::byte> pixels(header.bytes());
    std::uint32_t state = 1;
    for (std::byte& b : pixels) {
        state = state * 1664525U + 1013904223U;
        b = static_cast<std::byte>(state >> 24U);
    }
    return pixels;
}

TEST(ImageFiles, sixteenBitGreyComesBackExactly) {
    const test::ScratchFolder folder;
    const ImageHeader header{ImageFormat::Grey16, 37, 11};
    const auto pixels = noise(header);
    devices::writePng(folder / "a.png", {header, pixels});
    const auto back = test::loadImage(folder / "a.png");
    EXPECT_EQ(back.header.format, ImageFormat::Grey16);
    EXPECT_EQ(back.header.width, 37);
    EXPECT_EQ(back.header.height, 11);
    EXPECT_EQ(back.pixels, pixels);
}

/// What a pixel of `format` should be read as; alpha is always 255.
std::vector<std::byte> asRgba(ImageFormat format, const std::vector<std::byte>& pixels) {
    const std::size_t channels = devices::bytesPerPixel(format);
    std::vector<std::byte> rgba;
    for (std::size_t i = 0; i < pixels.size(); i += channels) {
        for (std::size_t c = 0; c < 3; ++c)
            rgba.push_back(pixels[i + (channels < 3 ? 0 : c)]);
        rgba.push_back(std::byte{255});
    }
    return rgba;
}

TEST(ImageFiles, eightBitFormatsComeBackAsRgba) {
    const test::ScratchFolder folder;
    for (const auto format : {ImageFormat::Grey8, ImageFormat::Rgb8, ImageFormat::Rgba8}) {
        const ImageHeader header{format, 19, 7};
        const auto pixels = noise(header);
        devices::writePng(folder / "a.png", {header, pixels});
        const auto back = test::loadImage(folder / "a.png");
        EXPECT_EQ(back.header.format, ImageFormat::Rgba8);
        EXPECT_EQ(back.pixels, asRgba(format, pixels));
    }
}

/// The text of a literal that has zero bytes in it.
template<std::size_t kLength>
std::string bytes(const char (&literal)[kLength]) {
    return {literal, kLength - 1};
}

TEST(ImageFiles, paletteIsExpanded) {
    const test::ScratchFolder folder;
    // 2x1 pixels of one bit, palette red and blue, indices 0 and 1.
    const auto path = folder.write(
        "palette.png",
        bytes("\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x02"
              "\x00\x00\x00\x01\x01\x03\x00\x00\x00\xce\xec\xed\xc9\x00\x00\x00\x06\x50\x4c\x54"
              "\x45\xff\x00\x00\x00\x00\xff\x6c\xa1\xfd\x8e\x00\x00\x00\x0a\x49\x44\x41\x54\x78"
              "\x9c\x63\x70\x00\x00\x00\x42\x00\x41\x29\x37\xf4\xef\x00\x00\x00\x00\x49\x45\x4e"
              "\x44\xae\x42\x60\x82"));
    const auto image = test::loadImage(path);
    EXPECT_EQ(image.header.width, 2);
    const std::vector<std::byte> expected{std::byte{255}, std::byte{0},  std::byte{0},
                                          std::byte{255}, std::byte{0},  std::byte{0},
                                          std::byte{255}, std::byte{255}};
    EXPECT_EQ(image.pixels, expected);
}

std::string errorOf(const std::filesystem::path& path) try {
    static_cast<void>(test::loadImage(path));
    return "";
} catch (const std::runtime_error& error) {
    return error.what();
}

TEST(ImageFiles, sizesAreRefusedBeforeTheyAreBelieved) {
    const test::ScratchFolder folder;
    const auto huge = folder.write(
        "huge.png",
        bytes( // 100000 x 100000
            "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x01\x86\xa0"
            "\x00\x01\x86\xa0\x08\x02\x00\x00\x00\x27\x30\x9c\x9f"));
    EXPECT_EQ(errorOf(huge), huge.string() + ": PNG 100000x100000 (allowed 1 to 16384)");
    const auto empty = folder.write(
        "empty.png",
        bytes( // 0 x 5
            "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x00"
            "\x00\x00\x00\x05\x08\x02\x00\x00\x00\xe4\x24\x7a\xf6"));
    EXPECT_EQ(errorOf(empty), empty.string() + ": PNG 0x5 (allowed 1 to 16384)");
    EXPECT_NE(errorOf(folder.write("none.png", "")), "");
    EXPECT_NE(errorOf(folder / "absent.png"), "");
    EXPECT_NE(errorOf(folder.path()), "");
}

/// A cut anywhere in the file is an error that names it, never half a picture.
void expectCutsAreErrors(const std::filesystem::path& whole) {
    const test::ScratchFolder folder;
    const auto data = devices::readFile(whole, 64U << 20U);
    const std::string text(reinterpret_cast<const char*>(data.data()), data.size());
    ASSERT_EQ(errorOf(whole), "");
    for (const std::size_t left :
         {data.size() - 1, data.size() - 13, data.size() * 3 / 4, data.size() / 2, std::size_t{600},
          std::size_t{34}, std::size_t{9}}) {
        const auto cut = folder.write("cut", text.substr(0, left));
        EXPECT_NE(errorOf(cut).find(cut.string()), std::string::npos) << left << " bytes left";
    }
}

TEST(ImageFiles, truncatedPngIsAnError) {
    AUTOSTEREO_NEED_DATA("k4a-mug/depth.png");
    expectCutsAreErrors(test::dataDir() / "k4a-mug/depth.png");
}

TEST(ImageFiles, truncatedJpegIsAnError) {
    AUTOSTEREO_NEED_DATA("k4a-mug/color.jpg");
    expectCutsAreErrors(test::dataDir() / "k4a-mug/color.jpg");
}

TEST(ImageFiles, aReaderGoesOnAfterAnError) {
    const test::ScratchFolder folder;
    const ImageHeader header{ImageFormat::Grey16, 8, 8};
    const auto pixels = noise(header);
    devices::writePng(folder / "good.png", {header, pixels});
    ImageReader reader;
    EXPECT_THROW(static_cast<void>(reader.open(folder.write("bad.png", "rubbish"))),
                 std::runtime_error);
    std::vector<std::byte> back(reader.open(folder / "good.png").bytes());
    reader.decode(back);
    EXPECT_EQ(back, pixels);
}

TEST(ImageFiles, aFailedWriteLeavesNothing) {
    const test::ScratchFolder folder;
    const ImageHeader header{ImageFormat::Grey8, 4, 4};
    const auto pixels = noise(header);
    EXPECT_THROW(devices::writePng(folder / "no/such/folder.png", {header, pixels}),
                 std::runtime_error);
    EXPECT_THROW(devices::writePng(folder / "short.png", {{ImageFormat::Rgb8, 4, 4}, pixels}),
                 std::runtime_error);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    devices::writePng(folder / "a.png", {header, pixels});
    const auto files = std::distance(std::filesystem::directory_iterator(folder.path()), {});
    EXPECT_EQ(files, 1) << "the temporary file is still there";
}

} // namespace
} // namespace autostereo

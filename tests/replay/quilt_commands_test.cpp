// interleave and viewmap through the program: a quilt's view lands where the view map says.

#include "devices/replay/image_files.hpp"
#include "devices/replay/npy_file.hpp"
#include "tests/replay/pictures.hpp"
#include "tests/replay/program.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace autostereo::test {
namespace {

ProgramResult call(std::vector<std::string> words) { return runProgram(calling(std::move(words))); }

/// 4 x 2 tiles of 30 x 20 pixels, tile i at level 20 i + 10 throughout; view 0 bottom left.
std::string writeQuilt(const TempFolder& folder, const std::string& name) {
    constexpr int kWidth = 120, kHeight = 40;
    std::vector<std::byte> pixels;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            pixels.insert(pixels.end(), 3,
                          static_cast<std::byte>(20 * ((1 - y / 20) * 4 + x / 30) + 10));
    const std::string file = folder / name;
    devices::writePng(file, {{devices::ImageFormat::Rgb8, kWidth, kHeight}, pixels});
    return file;
}

std::vector<std::uint16_t> viewsOf(const std::string& file) {
    const devices::NpyArray array = devices::readNpy(file, std::size_t{1} << 30);
    EXPECT_EQ(array.header.type, "<u2");
    std::vector<std::uint16_t> views(array.header.elements());
    std::memcpy(views.data(), array.data.data(), array.data.size());
    return views;
}

TEST(QuiltCommands, EverySubpixelShowsItsViewsTile) {
    const TempFolder folder;
    const std::string display = "slanted-8view-1080p", panel = folder / "panel.png";
    ASSERT_TRUE(succeeded(call({"interleave", "--quilt", writeQuilt(folder, "q_qs4x2a1.5.png"),
                                "--display", display, "--output", panel})));
    ASSERT_TRUE(succeeded(
        call({"viewmap", "--display", display, "--index", "--output", folder / "views.npy"})));
    const ColorPicture shown = readColor(panel);
    const auto views = viewsOf(folder / "views.npy");
    ASSERT_EQ(views.size(), 3U * 1920 * 1080);
    std::size_t at = 0, wrong = 0;
    for (int y = 0; y < 1080; ++y)
        for (int x = 0; x < 1920; ++x)
            for (int c = 0; c < 3; ++c)
                wrong += shown.at(x, y)[c] != 20 * views[at++] + 10;
    EXPECT_EQ(wrong, 0U);
}

TEST(QuiltCommands, TilesComeFromNameOrOptions) {
    const TempFolder folder;
    const std::string plain = writeQuilt(folder, "plain.png"), panel = folder / "panel.png";
    const std::vector<std::string> words{"interleave", "--quilt",  plain, "--display",
                                         "preview",    "--output", panel};
    const ProgramResult nameless = call(words);
    EXPECT_TRUE(failedPlainly(nameless, 2));
    EXPECT_NE(nameless.err.find("does not say its tiles"), std::string::npos) << nameless.err;
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), words.begin(), words.end());
        return call(more);
    };
    EXPECT_TRUE(succeeded(with({"--columns", "2", "--rows", "1"})));
    EXPECT_TRUE(failedPlainly(with({"--columns", "4", "--rows", "2"}), 2)) << "preview has 2 views";
    EXPECT_TRUE(succeeded(with({"--columns", "4", "--rows", "2", "--views", "2"})));
    EXPECT_TRUE(failedPlainly(with({"--columns", "2", "--rows", "90"}), 2));
    EXPECT_TRUE(failedPlainly(with({"--columns", "2", "--rows", "2", "--views", "5"}), 2));
}

TEST(QuiltCommands, ViewmapCountsTheTexelsThatAreShown) {
    const TempFolder folder;
    const ProgramResult result =
        call({"viewmap", "--display", "looking-glass-portrait", "--json", "--texels",
              folder / "mask.png", "--output", folder / "phases.npy"});
    ASSERT_TRUE(succeeded(result));
    const auto texels = nlohmann::json::parse(result.out).at("texels");
    // Three channels of each panel pixel, no texel twice: 1536 x 2048 x 3.
    EXPECT_EQ(texels.at("channels_read"), 9437184);
    EXPECT_NEAR(texels.at("read_share").get<double>(), 0.588, 0.001);
    const auto phases = devices::readNpy(folder / "phases.npy", std::size_t{1} << 30);
    EXPECT_EQ(phases.header.type, "<u4");
    EXPECT_EQ(phases.header.shape, (std::vector<std::size_t>{2048, 1536, 3}));
}

TEST(QuiltCommands, EyesCountForTrackedDisplaysOnly) {
    const TempFolder folder;
    EXPECT_TRUE(
        succeeded(call({"viewmap", "--display", "personal-varrier-30", "--eye", "-0.03,0,0.6",
                        "--eye", "0.03,0.1,0.6", "--output", folder / "two.npy"})));
    EXPECT_EQ(devices::readNpy(folder / "two.npy", std::size_t{1} << 30).header.shape,
              (std::vector<std::size_t>{2, 1600, 2560, 3}));
    EXPECT_TRUE(failedPlainly(call({"viewmap", "--display", "slanted-8view-1080p", "--eye", "0,0,1",
                                    "--output", folder / "x.npy"}),
                              2));
    EXPECT_TRUE(
        failedPlainly(call({"viewmap", "--display", "wowvx-42", "--output", folder / "x.npy"}), 2));
}

/// A real quilt of 33 photographs, its last two tiles empty.
TEST(QuiltCommands, ARealQuilt) {
    AUTOSTEREO_NEED_DATA("quilts");
    const TempFolder folder;
    const std::string quilt =
        (dataDir() / "quilts/green-buddha/GreenBuddha_qs7x5a0.5625.jpg").string();
    for (const char* filter : {"nearest", "blend"})
        EXPECT_TRUE(succeeded(call({"interleave", "--quilt", quilt, "--views", "33", "--display",
                                    "looking-glass-portrait", "--filter", filter, "--output",
                                    folder / "panel.png"})));
}

std::vector<std::string> rendering(const std::string& settings, const char* what,
                                   const std::string& output) {
    return {"render",
            "--config",
            settings,
            "--input",
            "sim:room?depth=160x144&color=320x180",
            "--display",
            "slanted-8view-1080p",
            "--as",
            what,
            "--output",
            output};
}

/// A quilt interleaved afterwards is the panel that the same method fills, to the byte.
TEST(QuiltCommands, OursIsThePanel) {
    for (const char* method : {"multipass", "instanced", "geometry", "mrt", "hybrid"}) {
        const TempFolder folder;
        const std::string settings =
            folder.file("autostereo.toml", std::string("[synthesis]\nfilter = \"nearest\"\n") +
                                               "method = \"" + method + "\"\n");
        const std::string quilt = folder / "room_qs4x2a1.78.png";
        ASSERT_TRUE(succeeded(call(rendering(settings, "quilt", quilt))));
        ASSERT_TRUE(succeeded(call(rendering(settings, "panel", folder / "panel.png"))));
        ASSERT_TRUE(
            succeeded(call({"interleave", "--quilt", quilt, "--display", "slanted-8view-1080p",
                            "--filter", "nearest", "--output", folder / "again.png"})));
        EXPECT_TRUE(readColor(folder / "again.png") == readColor(folder / "panel.png")) << method;
    }
}

/// As public players count: the leftmost view is the bottom left tile, then rightwards, then up.
TEST(QuiltCommands, OursCountsAsPlayersDo) {
    const TempFolder folder;
    const std::string settings =
        folder.file("autostereo.toml", "[synthesis]\nmethod = \"multipass\"\n");
    ASSERT_TRUE(succeeded(call(rendering(settings, "quilt", folder / "quilt.png"))));
    ASSERT_TRUE(succeeded(call(rendering(settings, "views", folder / "views"))));
    const ColorPicture quilt = readColor(folder / "quilt.png");
    constexpr int kWidth = 640, kHeight = 360;
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "views"))
        files.push_back(entry.path());
    std::ranges::sort(files);
    ASSERT_EQ(files.size(), 8U);
    for (int view = 0; view < 8; ++view) {
        const ColorPicture alone = readColor(files[static_cast<std::size_t>(view)]);
        ASSERT_EQ(alone.width, kWidth);
        std::size_t wrong = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                for (int c = 0; c < 3; ++c)
                    wrong += alone.at(x, y)[c] !=
                             quilt.at(x + kWidth * (view % 4), y + kHeight * (1 - view / 4))[c];
        EXPECT_EQ(wrong, 0U) << view;
    }
}

} // namespace
} // namespace autostereo::test

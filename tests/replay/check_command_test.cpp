#include "tests/replay/program.hpp"
#include "tests/support/data.hpp"
#include "tests/support/edid_bytes.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace autostereo::test {
namespace {

ProgramResult check(std::vector<std::string> files) {
    files.insert(files.begin(), "check");
    return runProgram(calling(std::move(files)));
}

TEST(CheckCommand, EveryShippedFileIsGood) {
    const std::filesystem::path config = sourceDir() / "config";
    std::vector<std::string> files{config / "default.toml"};
    for (const char* folder : {"displays", "rigs"})
        for (const auto& entry : std::filesystem::directory_iterator(config / folder))
            files.push_back(entry.path());
    EXPECT_GE(files.size(), 6U);
    const ProgramResult result = check(files);
    EXPECT_TRUE(succeeded(result));
    EXPECT_EQ(std::ranges::count(result.out, '\n'), static_cast<std::ptrdiff_t>(files.size()));
}

TEST(CheckCommand, RecordingsAndCamerasAreGood) {
    AUTOSTEREO_NEED_DATA("k4a-mug/recording.mkv");
    const auto mug = dataDir() / "k4a-mug";
    EXPECT_TRUE(succeeded(check({mug / "recording.mkv", mug / "camera.json"})));
}

/// One line for each bad file, and the good ones are still looked at.
TEST(CheckCommand, BrokenFilesAreNamed) {
    const TempFolder folder;
    const std::string good = smallDisplay(folder);
    const std::string unknownKey = folder.file("key.toml", "[input]\nurl = \"sim:room\"\n");
    const std::string broken = folder.file("broken.toml", "[input\n");
    const std::string json = folder.file("broken.json", "{");
    const std::string recording = folder.file("broken.mkv", "nothing");
    const ProgramResult result =
        check({unknownKey, broken, json, recording, folder / "none.toml", good});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 5) << result.err;
    EXPECT_NE(result.err.find(unknownKey + ":2:1: "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(broken + ":1:"), std::string::npos) << result.err;
    EXPECT_NE(result.out.find(good + ": good"), std::string::npos) << result.out;
}

TEST(DevicesCommand, ListsAsJson) {
    const ProgramResult result = runProgram(calling({"devices", "--json"}));
    ASSERT_TRUE(succeeded(result));
    const auto found = nlohmann::json::parse(result.out);
    EXPECT_TRUE(found.at("monitors").empty()) << "there is no display server";
    std::vector<std::string> names;
    for (const auto& display : found.at("displays"))
        names.push_back(display.at("name"));
    for (const char* name :
         {"barrier-5view", "looking-glass-portrait", "preview", "slanted-8view-1080p"})
        EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
    EXPECT_FALSE(found.at("inputs").empty());
    EXPECT_TRUE(succeeded(runProgram(calling({"devices"}))));
}

/// A machine with one monitor, a Looking Glass volume that is mounted and one that is not.
void furnish(const TempFolder& root) {
    const Bytes edid = syntheticEdid("LKG01Do12HjQ", 1536, 2048);
    const std::string monitor = "sys/class/drm/card0-HDMI-A-1/";
    (void)root.file(monitor + "status", "connected\n");
    (void)root.file(monitor + "enabled", "enabled\n");
    (void)root.file(monitor + "modes", "1536x2048\n1280x720\n");
    (void)root.file(monitor + "edid", {reinterpret_cast<const char*>(edid.data()), edid.size()});
    (void)root.file("dev/dri/card0", "no card");
    (void)root.file("proc/mounts", "/dev/sda1 /media/LKG\\040A vfat ro 0 0\n");
    (void)root.file("media/LKG A/LKG_calibration/visual.json", "{}");
    (void)root.file("dev/disk/by-label/README", "");
    std::filesystem::create_symlink("../../sda1", root / "dev/disk/by-label/LKG-A");
    std::filesystem::create_symlink("../../sdb1", root / "dev/disk/by-label/LKG-B\\xff");
}

TEST(DevicesCommand, ListsConnectorsAndVolumesBelowARoot) {
    const TempFolder root;
    furnish(root);
    const ProgramResult result = runProgram(calling({"devices", "--json", "--root", root / ""}));
    ASSERT_TRUE(succeeded(result));
    const auto found = nlohmann::json::parse(result.out);
    ASSERT_EQ(found.at("connectors").size(), 1U);
    const auto& connector = found.at("connectors")[0];
    EXPECT_EQ(connector.at("connector"), "HDMI-A-1");
    EXPECT_EQ(connector.at("edid").at("name"), "LKG01Do12HjQ");
    EXPECT_EQ(connector.at("edid").at("height"), 2048);
    EXPECT_EQ(connector.at("modes"), (std::vector<std::string>{"1536x2048", "1280x720"}));
    EXPECT_TRUE(connector.at("link").empty()) << connector.at("link");
    ASSERT_EQ(found.at("unread_cards").size(), 1U);
    ASSERT_EQ(found.at("looking_glass").size(), 2U);
    EXPECT_EQ(found.at("looking_glass")[0].at("calibration"),
              root / "media/LKG A/LKG_calibration/visual.json");
    EXPECT_TRUE(found.at("looking_glass")[1].at("calibration").is_null());

    const ProgramResult words = runProgram(calling({"devices", "--root", root / ""}));
    ASSERT_TRUE(succeeded(words));
    for (const char* part : {"card0 HDMI-A-1: TSB 'LKG01Do12HjQ' 1536x2048\n",
                             "/dev/sdb1 is not mounted\n", "card0: drives no monitors"})
        EXPECT_NE(words.out.find(part), std::string::npos) << part << "\n" << words.out;
}

TEST(Help, HasAnExampleForEachCommand) {
    for (const char* command : {"run", "render", "interleave", "viewmap", "look", "pattern",
                                "import", "check", "devices"}) {
        const ProgramResult result = runProgram(calling({command, "--help"}));
        EXPECT_TRUE(succeeded(result)) << command;
        EXPECT_NE(result.out.find("Example: autostereo " + std::string(command)), std::string::npos)
            << result.out;
    }
}

} // namespace
} // namespace autostereo::test

#include "tests/replay/program.hpp"
#include "tests/support/data.hpp"

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

TEST(Help, HasAnExampleForEachCommand) {
    for (const char* command : {"run", "render", "check", "devices"}) {
        const ProgramResult result = runProgram(calling({command, "--help"}));
        EXPECT_TRUE(succeeded(result)) << command;
        EXPECT_NE(result.out.find("Example: autostereo " + std::string(command)), std::string::npos)
            << result.out;
    }
}

} // namespace
} // namespace autostereo::test

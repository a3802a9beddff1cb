// Method auto: tries all methods at the first start, keeps what it chose, and starts again from a
// file that is broken.

#include "tests/replay/program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace autostereo::test {
namespace {

class AutoMethod : public testing::Test {
  protected:
    /// What it said; the report's method goes to `method`.
    std::string start(const char* leastDb, std::string& method) {
        const std::string config = folder.file(
            "auto.toml",
            std::string("[synthesis]\nmethod = \"auto\"\nmax_error_db = ") + leastDb + "\n");
        ProgramCall call = calling({"run", "--config", config, "--input", kSmallRoom, "--display",
                                    display, "--output", "offscreen", "--speed", "max", "--frames",
                                    "2", "--report", folder / "report.json"});
        call.environment.emplace_back("STATE_DIRECTORY=" + (folder / "state"));
        const ProgramResult result = runProgram(call);
        EXPECT_TRUE(succeeded(result));
        std::ifstream report(folder / "report.json");
        method = nlohmann::json::parse(report).at("method").get<std::string>();
        return result.err;
    }
    [[nodiscard]] static bool tried(const std::string& said) {
        return said.find("method multipass:") != std::string::npos;
    }

    TempFolder folder;
    std::string display = smallDisplay(folder);
};

TEST_F(AutoMethod, TriesOnceAndKeepsWhatItChose) {
    std::string first, second;
    EXPECT_TRUE(tried(start("50", first)));
    EXPECT_EQ(first, "direct") << "nothing else is within 50 dB";
    EXPECT_FALSE(tried(start("50", second)));
    EXPECT_EQ(second, first);
    EXPECT_TRUE(tried(start("20", second))) << "another bound is another question";
}

TEST_F(AutoMethod, ABrokenFileIsTriedAgain) {
    std::string method;
    static_cast<void>(start("50", method));
    for (const auto& file :
         std::filesystem::directory_iterator(std::filesystem::path(folder / "state") / "methods"))
        std::ofstream(file.path()) << "{\"method\": 7";
    EXPECT_TRUE(tried(start("50", method)));
    EXPECT_EQ(method, "direct");
}

} // namespace
} // namespace autostereo::test

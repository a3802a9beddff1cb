#include "config/load.hpp"
#include "tests/support/data.hpp"
#include "tests/unit/config/temp_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>
#include <regex>

namespace autostereo::config {
namespace {

std::string shipped(const std::string& name) {
    std::ifstream in(test::sourceDir() / "config" / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Some bytes overwritten, or the end cut off.
std::string damaged(std::string text, std::mt19937& random) {
    const auto any = [&random](std::size_t below) { return random() % below; };
    if (any(4) == 0) return text.substr(0, any(text.size()));
    for (std::size_t flips = 1 + any(4); flips > 0; --flips)
        text[any(text.size())] = static_cast<char>(any(256));
    return text;
}

class DamagedFiles : public test::TempFolder {};

// Loads, or says where it is wrong in one line; nothing else leaves the loaders.
TEST_F(DamagedFiles, loadOrSayWhere) {
    const std::regex form(R"(x\.toml:[0-9]+:[0-9]+: [^\n]+: [^\n]+)");
    std::mt19937 random(20260131);
    int refused = 0;
    constexpr int kRounds = 600;
    for (int i = 0; i < kRounds; ++i) {
        const char* names[] = {"default.toml", "displays/looking-glass-portrait.toml",
                               "rigs/example.toml"};
        const int kind = i % 3;
        const std::string text = damaged(shipped(names[kind]), random);
        write("x.toml", text);
        const std::string message = test::messageOf<ConfigError>([&] {
            if (kind == 0) (void)loadConfig("x.toml");
            if (kind == 1) (void)loadDisplay("x.toml");
            if (kind == 2) (void)loadRig("x.toml");
        });
        if (message == "no error") continue; // in a comment, or still a good value
        ++refused;
        ASSERT_TRUE(std::regex_match(message, form)) << message << "\n--- of\n" << text;
    }
    EXPECT_GT(refused, kRounds / 10);
}

} // namespace
} // namespace autostereo::config

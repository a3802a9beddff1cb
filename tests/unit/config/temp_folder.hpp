#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace autostereo::test {

/// Each test in its own empty working folder, so that messages name files without a path.
class TempFolder : public ::testing::Test {
  protected:
    void SetUp() override {
        before_ = std::filesystem::current_path();
        std::string pattern = (std::filesystem::temp_directory_path() / "config.XXXXXX").string();
        ASSERT_NE(mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
        std::filesystem::current_path(folder_);
    }
    void TearDown() override {
        std::filesystem::current_path(before_);
        std::filesystem::remove_all(folder_);
    }

    static void write(const std::string& name, std::string_view text) {
        std::ofstream(name, std::ios::binary) << text;
    }

  private:
    std::filesystem::path before_;
    std::filesystem::path folder_;
};

/// `text` with the one place where `from` stands replaced; "" replaces everything.
inline std::string edited(std::string text, std::string_view from, std::string_view to) {
    if (from.empty()) return std::string(to);
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << "no \"" << from << "\" to replace";
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// What a call threw, or "no error".
template<class Error, class Call>
std::string messageOf(Call&& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

} // namespace autostereo::test

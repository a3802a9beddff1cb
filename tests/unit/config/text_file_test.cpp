#include "config/text_file.hpp"

#include "config/load.hpp"
#include "tests/support/data.hpp"
#include "tests/unit/config/temp_folder.hpp"

#include <gtest/gtest.h>

namespace autostereo::config {
namespace {

class TextFile : public test::TempFolder {};

TEST_F(TextFile, embeddedTextsAreTheFilesByteForByte) {
    const auto names = embeddedNames("");
    EXPECT_EQ(names.size(), 43U);
    for (const std::string& name : names)
        EXPECT_EQ(embeddedText(name), readTextFile(test::sourceDir() / "config" / name)) << name;
    EXPECT_TRUE(embeddedText("no.toml").empty());
}

TEST_F(TextFile, keepsEveryByte) {
    const std::string_view text("a\r\n\0\xff\n", 6);
    write("x", text);
    EXPECT_EQ(readTextFile("x"), text);
}

TEST_F(TextFile, saysWhyItCannotBeRead) {
    const auto message = [](const char* file) {
        return test::messageOf<ConfigError>([&] { (void)readTextFile(file); });
    };
    EXPECT_EQ(message("no.toml"), "no.toml: cannot be read: No such file or directory");
    EXPECT_EQ(message("."), ".: cannot be read: Is a directory");
    EXPECT_EQ(message("/dev/zero"), "/dev/zero: cannot be read: it is longer than 1 MiB");
    EXPECT_EQ(message("no\n.toml"), "no?.toml: cannot be read: No such file or directory");
}

} // namespace
} // namespace autostereo::config

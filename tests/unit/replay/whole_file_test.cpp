#include "devices/replay/whole_file.hpp"
#include "tests/unit/config/temp_folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <iterator>

namespace autostereo::devices {
namespace {

class WholeFile : public test::TempFolder {
  protected:
    static std::string contents(const std::string& name) {
        std::ifstream file(name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
};

TEST_F(WholeFile, ReplacesAFileAndKeepsTheOldOneWhereAsked) {
    writeWhole("a", "one");
    writeWhole("a", "two");
    EXPECT_EQ(contents("a"), "two");
    replaceKeepingOld("a", "three");
    EXPECT_EQ(contents("a"), "three");
    EXPECT_EQ(contents("a.old"), "two");
}

/// Root could put a file in a device's place.
TEST_F(WholeFile, NeverReplacesWhatIsNoFile) {
    ASSERT_EQ(mkfifo("pipe", 0600), 0);
    EXPECT_THROW(writeWhole("pipe", "text"), std::runtime_error);
    EXPECT_TRUE(std::filesystem::is_fifo("pipe"));
    std::filesystem::create_directory("folder");
    EXPECT_THROW(writeWhole("folder", "text"), std::runtime_error);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator("."), {}), 2) << "nothing is left";
}

} // namespace
} // namespace autostereo::devices

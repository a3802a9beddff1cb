// Cameras as sysfs shows them, in a folder of our own.

#include "devices/kinect2/usb/find_units.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace autostereo {
namespace {

using namespace devices::kinect2;
namespace fs = std::filesystem;

class FindUnitsTest : public testing::Test {
  protected:
    void write(const std::string& file, const std::string& text) const {
        fs::create_directories((root() / file).parent_path());
        std::ofstream(root() / file) << text;
    }
    void plugIn(const std::string& port, const std::string& product, const std::string& serial,
                const std::string& speed) const {
        const std::string usb = "sys/bus/usb/devices/" + port + "/";
        write(usb + "idVendor", "045e\n");
        write(usb + "idProduct", product + "\n");
        write(usb + "serial", serial + "\n");
        write(usb + "speed", speed + "\n");
        write(usb + "busnum", "2\n");
        write(usb + "devnum", "17\n");
    }
    [[nodiscard]] fs::path root() const { return folder.path(); }

    test::ScratchFolder folder;
};

TEST_F(FindUnitsTest, BothModelsInTheOrderOfTheirPortsAndNothingElse) {
    EXPECT_TRUE(findUnits(root()).empty());
    plugIn("2-2.1", "02c4", "B", "5000");
    plugIn("2-1.1", "02d8", "A", "5000");
    plugIn("2-1", "02d9", "its hub", "5000");
    write("sys/bus/usb/devices/usb1/idVendor", "1d6b\n");
    const auto units = findUnits(root());
    ASSERT_EQ(units.size(), 2U);
    EXPECT_EQ(units[0].serial, "A");
    EXPECT_EQ(units[0].port, "2-1.1");
    EXPECT_EQ(units[0].node, root() / "dev/bus/usb/002/017");
    EXPECT_EQ(units[0].usbMbps, 5000);
    EXPECT_EQ(units[1].serial, "B");
}

TEST_F(FindUnitsTest, WhatKeepsItFromWorkingIsSaid) {
    plugIn("2-1", "02d8", "A", "480");
    write("sys/module/usbcore/parameters/usbfs_memory_mb", "8\n");
    const auto problems = problemsWith(findUnits(root()).front(), root());
    ASSERT_EQ(problems.size(), 3U);
    EXPECT_EQ(problems[0],
              "it needs USB 3 and runs at 480 Mb/s: try a blue port and another cable");
    EXPECT_NE(problems[1].find("70-autostereo.rules"), std::string::npos);
    EXPECT_NE(problems[2].find("may take 8 MiB for USB transfers, it needs 14"), std::string::npos);
    plugIn("2-1", "02d8", "A", "5000");
    write("sys/module/usbcore/parameters/usbfs_memory_mb", "16\n");
    write("dev/bus/usb/002/017", "");
    EXPECT_TRUE(problemsWith(findUnits(root()).front(), root()).empty());
}

} // namespace
} // namespace autostereo

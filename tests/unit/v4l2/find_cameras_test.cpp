// Cameras as sysfs shows them, in a folder of our own.

#include "devices/sysfs.hpp"
#include "devices/v4l2/camera_report.hpp"
#include "devices/v4l2/find_cameras.hpp"
#include "devices/v4l2/node_holders.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace autostereo {
namespace {

using namespace devices::v4l2;
namespace fs = std::filesystem;

class FindCamerasTest : public testing::Test {
  protected:
    void write(const std::string& file, const std::string& text) const {
        fs::create_directories((root() / file).parent_path());
        std::ofstream(root() / file) << text;
    }
    /// A camera at port `port` of bus 1, with its metadata node.
    void plugIn(int number, const std::string& port, const std::string& serial,
                const std::string& speed) const {
        const std::string usb = "sys/devices/pci0000:00/0000:00:14.0/usb1/" + port;
        write(usb + "/idVendor", "1209\n");
        write(usb + "/serial", serial + "\n");
        write(usb + "/speed", speed + "\n");
        write(usb + "/version", " 3.20\n");
        fs::create_directories(root() / usb / (port + ":1.0"));
        for (int index = 0; index < 2; ++index) {
            const std::string node = "sys/class/video4linux/video" + std::to_string(number + index);
            write(node + "/name", "Camera " + serial + "\n");
            write(node + "/index", std::to_string(index) + "\n");
            fs::create_symlink(root() / usb / (port + ":1.0"), root() / node / "device");
        }
    }
    [[nodiscard]] fs::path root() const { return folder.path(); }

    test::ScratchFolder folder;
};

TEST_F(FindCamerasTest, NodesInTheOrderOfTheirNumbers) {
    plugIn(10, "1-2", "B", "480");
    plugIn(2, "1-1.4", "A", "5000");
    write("sys/class/video4linux/v4l-subdev0/name", "no camera\n");
    write("sys/class/video4linux/video1/name", "on no USB\n");
    const auto nodes = findCameras(root());
    ASSERT_EQ(nodes.size(), 5U);
    EXPECT_EQ(nodes[0].path, root() / "dev/video1");
    EXPECT_EQ(nodes[0].usbMbps, 0);
    EXPECT_EQ(nodes[1].name, "Camera A");
    EXPECT_EQ(nodes[1].serial, "A");
    EXPECT_EQ(nodes[1].bus, "usb-0000:00:14.0-1.4");
    EXPECT_EQ(nodes[1].usbMbps, 5000);
    EXPECT_TRUE(nodes[1].usb3);
    EXPECT_EQ(nodes[2].index, 1);
    EXPECT_EQ(nodes[3].path, root() / "dev/video10");
    EXPECT_TRUE(findCameras(root() / "nothing").empty());
}

TEST_F(FindCamerasTest, ACameraIsFoundByItsName) {
    plugIn(0, "1-1", "A", "480");
    plugIn(2, "1-2", "B", "480");
    const auto nodes = findCameras(root());
    const auto found = [&](const CameraName& name) {
        std::vector<std::string> names;
        for (const fs::path& path : candidates(name, nodes))
            names.push_back(path.filename());
        return names;
    };
    using By = CameraName::By;
    using Names = std::vector<std::string>;
    EXPECT_EQ(found({By::Serial, "B"}), (Names{"video2", "video3"}));
    EXPECT_EQ(found({By::Serial, "B", 0}), (Names{"video2"}));
    EXPECT_EQ(found({By::Bus, "usb-0000:00:14.0-1"}), (Names{"video0", "video1"}));
    EXPECT_EQ(found({By::Serial, "C"}), Names{});
    EXPECT_EQ(found({}), (Names{"video0", "video1", "video2", "video3"}));
    EXPECT_EQ(found({By::Path, "/dev/other"}), (Names{"other"}));
}

TEST_F(FindCamerasTest, HoldersOfANodeAreNamed) {
    write("dev/video0", "");
    write("proc/77/comm", "cheese\n");
    fs::create_directories(root() / "proc/77/fd");
    fs::create_symlink(root() / "dev/video0", root() / "proc/77/fd/5");
    write("proc/88/comm", "bash\n");
    fs::create_directories(root() / "proc/88/fd");
    fs::create_symlink("/dev/null", root() / "proc/88/fd/0");
    write("proc/meminfo", "");
    EXPECT_EQ(holdersOf(root() / "dev/video0", root() / "proc"), "cheese (pid 77)");
    EXPECT_EQ(holdersOf(root() / "dev/video1", root() / "proc"), "");
    EXPECT_EQ(holdersOf(root() / "dev/video0", root() / "none"), "");
}

TEST_F(FindCamerasTest, ProblemsAreReportedWithWhatToDo) {
    plugIn(0, "1-1", "A", "480");
    write("sys/module/usbcore/parameters/usbfs_memory_mb", "16\n");
    const auto reports = reportCameras(root());
    ASSERT_EQ(reports.size(), 2U);
    ASSERT_EQ(reports[0].problems.size(), 2U);
    EXPECT_NE(reports[0].problems[0].find("No such file"), std::string::npos);
    EXPECT_NE(reports[0].problems[1].find("runs at 480 Mb/s"), std::string::npos);
    EXPECT_EQ(devices::usbMemoryMib(root()), 16);
    EXPECT_FALSE(devices::usbMemoryMib(root() / "none"));
}

} // namespace
} // namespace autostereo

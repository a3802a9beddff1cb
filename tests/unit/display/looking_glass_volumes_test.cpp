#include "devices/display/looking_glass_volumes.hpp"

#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <random>

#include <sys/stat.h>

namespace autostereo::test {
namespace {

using namespace devices;

TEST(Mounts, OctalEscapesAndOddLines) {
    const auto mounts = parseMounts("/dev/sda1 /media/LKG\\040P\\134x vfat ro,nosuid 0 0\n"
                                    "short line\n"
                                    "\n"
                                    "/dev/sdb1 /mnt/a\\0 ext4 rw 0 0\n"
                                    "/dev/sdc1 /mnt/b\\999 ext4 rw 0 0\n"
                                    "tmpfs /tmp\\011 tmpfs");
    EXPECT_EQ(mounts, (std::vector<Mount>{{"/dev/sda1", "/media/LKG P\\x", "vfat"},
                                          {"/dev/sdb1", "/mnt/a\\0", "ext4"},
                                          {"/dev/sdc1", "/mnt/b\\999", "ext4"},
                                          {"tmpfs", "/tmp\t", "tmpfs"}}));
}

TEST(Mounts, AnyTextIsTaken) {
    std::mt19937 random(7);
    const std::string letters = "\\0123456789 \n\t/dev";
    for (int round = 0; round < 300; ++round) {
        std::string text;
        for (auto size = random() % 200; size > 0; --size)
            text += letters[random() % letters.size()];
        for (const Mount& mount : parseMounts(text))
            EXPECT_FALSE(mount.type.empty());
    }
}

class Volumes : public testing::Test {
  protected:
    void mount(const std::string& device, const std::string& point, const std::string& type,
               const std::string& calibration) {
        mountTable += device + " " + point + " " + type + " rw 0 0\n";
        std::filesystem::create_directories(root / "proc");
        root.write("proc/mounts", mountTable);
        if (!calibration.empty()) write(unescaped(point).substr(1), calibration);
    }
    void write(const std::string& folder, const std::string& calibration) const {
        std::filesystem::create_directories(root / (folder + "/LKG_calibration"));
        root.write(folder + "/LKG_calibration/visual.json", calibration);
    }
    void label(const std::string& name, const std::string& target) const {
        std::filesystem::create_directories(root / "dev/disk/by-label");
        std::filesystem::create_symlink(target, root / ("dev/disk/by-label/" + name));
    }
    static std::string unescaped(std::string text) {
        if (const auto at = text.find("\\040"); at != std::string::npos) text.replace(at, 4, " ");
        return text;
    }
    ScratchFolder root;
    std::string mountTable;
};

TEST_F(Volumes, NothingInAnEmptyRoot) {
    EXPECT_TRUE(findLookingGlassVolumes(root.path(), "/home/x").empty());
}

TEST_F(Volumes, FoundByLabelAndMount) {
    label("LKG-P00001", "../../sda1");
    label("LKG-E\\x20two", "../../sdb1");
    label("BACKUP", "../../sdc1");
    mount("/dev/sda1", "/media/kiosk/LKG\\040one", "vfat", "{\"a\":1}");
    mount("/dev/sdd1", "/media/kiosk/renamed", "exfat", "{\"d\":1}");
    mount("/dev/sdc1", "/media/kiosk/backup", "ext4", "");

    const auto found = findLookingGlassVolumes(root.path(), "/home/kiosk");
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].label, "LKG-E two");
    EXPECT_EQ(found[0].device, "/dev/sdb1");
    EXPECT_FALSE(found[0].calibration) << "not mounted";
    EXPECT_EQ(found[1].label, "LKG-P00001");
    ASSERT_TRUE(found[1].calibration);
    EXPECT_EQ(readCalibrationText(*found[1].calibration), "{\"a\":1}");
    EXPECT_EQ(found[2].label, "renamed");
    ASSERT_TRUE(found[2].calibration);
    EXPECT_EQ(readCalibrationText(*found[2].calibration), "{\"d\":1}");
}

TEST_F(Volumes, OpticalAndNetworkMountsAreNotTouched) {
    mount("/dev/sr0", "/media/cdrom", "iso9660", "{}");
    mount("/dev/sr1", "/media/dvd", "udf", "{}");
    mount("server:/export", "/net", "nfs4", "{}");
    mount("tmpfs", "/ram", "tmpfs", "{}");
    EXPECT_TRUE(findLookingGlassVolumes(root.path(), "").empty());
    mount("/dev/sda1", "/media/stick", "vfat", "{}");
    EXPECT_EQ(findLookingGlassVolumes(root.path(), "").size(), 1U);
}

TEST_F(Volumes, BridgesCopies) {
    const std::string bridge = "home/kiosk/.local/share/LookingGlass/Bridge/Locations/";
    write(bridge + "LKG-P00002", "{\"b\":2}");
    std::filesystem::create_directories(root / (bridge + "LKG-EMPTY"));
    const auto found = findLookingGlassVolumes(root.path(), "/home/kiosk");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].label, "LKG-P00002");
    EXPECT_EQ(found[0].device, "");
    EXPECT_EQ(readCalibrationText(found[0].calibration.value()), "{\"b\":2}");
    EXPECT_TRUE(findLookingGlassVolumes(root.path(), "").empty());
}

TEST_F(Volumes, ReadsAreBounded) {
    const auto file = root.write("visual.json", std::string(1U << 20U, ' '));
    EXPECT_EQ(readCalibrationText(file).value().size(), 1U << 20U);
    root.write("visual.json", std::string((1U << 20U) + 1, ' '));
    EXPECT_FALSE(readCalibrationText(file));
    EXPECT_FALSE(readCalibrationText(root.path())) << "a folder";
    EXPECT_FALSE(readCalibrationText(root / "missing"));
    EXPECT_FALSE(readCalibrationText("/dev/zero"));
    ASSERT_EQ(::mkfifo((root / "pipe").c_str(), 0600), 0);
    EXPECT_FALSE(readCalibrationText(root / "pipe")) << "not an empty text either";
}

} // namespace
} // namespace autostereo::test

#include "devices/display/connectors.hpp"

#include "tests/support/edid_bytes.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>

namespace autostereo::test {
namespace {

using devices::connectedMonitors;
using devices::Connector;

class Connectors : public testing::Test {
  protected:
    void add(const std::string& name, const std::string& status, const Bytes& edid,
             const std::string& modes) const {
        const std::string at = "sys/class/drm/" + name;
        std::filesystem::create_directories(root / at);
        root.write(at + "/status", status + "\n");
        root.write(at + "/enabled", "enabled\n");
        root.write(at + "/modes", modes);
        root.write(at + "/edid",
                   std::string(reinterpret_cast<const char*>(edid.data()), edid.size()));
    }
    ScratchFolder root;
};

TEST_F(Connectors, ListsWhatIsConnected) {
    add("card1-HDMI-A-2", "connected", bytesOfHex(kDell),
        "1920x1080\n1920x1080\n1920x1080i\n1280x720\n0x0\nnonsense\n99999999999x1\n");
    add("card0-eDP-1", "connected", bytesOfHex(kBoe), "2256x1504\n");
    add("card0-DP-1", "disconnected", {}, "");
    add("card0-DP-2", "unknown", {}, "");
    add("renderD128", "connected", {}, "");
    std::filesystem::create_directories(root / "sys/class/drm/card0");
    root.write("sys/class/drm/version", "drm 1.1.0");

    const auto found = connectedMonitors(root.path());
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].card, "card0");
    EXPECT_EQ(found[0].name, "eDP-1");
    EXPECT_EQ(found[1].card, "card1");
    EXPECT_EQ(found[1].name, "HDMI-A-2");
    EXPECT_TRUE(found[1].enabled);
    ASSERT_TRUE(found[1].edid);
    EXPECT_EQ(found[1].edid->monitorName, "DELL D2721H");
    EXPECT_EQ(found[1].edidProblem, "");
    EXPECT_EQ(found[1].modes, (std::vector<Connector::Mode>{{1920, 1080}, {1280, 720}}));
    EXPECT_TRUE(found[1].offers(1280, 720));
    EXPECT_FALSE(found[1].offers(1280, 721));
}

TEST_F(Connectors, OffersThePreferredTimingOrAMode) {
    add("card0-DP-1", "connected", syntheticEdid("LKG", 3840, 2160), "7680x4320\n");
    const auto found = connectedMonitors(root.path());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].offers(3840, 2160));
    EXPECT_TRUE(found[0].offers(7680, 4320));
    EXPECT_FALSE(found[0].offers(2160, 3840));
}

TEST_F(Connectors, SaysWhyThereIsNoEdid) {
    add("card0-DP-1", "connected", {}, "");
    Bytes broken = bytesOfHex(kDell);
    broken[30] ^= std::byte{1};
    add("card0-DP-2", "connected", broken, "1024x768\n");
    const auto found = connectedMonitors(root.path());
    ASSERT_EQ(found.size(), 2U);
    EXPECT_FALSE(found[0].edid || found[1].edid);
    EXPECT_NE(found[0].edidProblem.find("no EDID"), std::string::npos);
    EXPECT_NE(found[1].edidProblem.find("checksum"), std::string::npos);
    EXPECT_TRUE(found[1].offers(1024, 768));
}

TEST_F(Connectors, OddFilesAreLeftOut) {
    EXPECT_TRUE(connectedMonitors(root.path()).empty()) << "there is no /sys";
    add("card0-DP-1", "connected", bytesOfHex(kBoe), std::string(1U << 20U, '1'));
    std::filesystem::remove(root / "sys/class/drm/card0-DP-1/edid");
    ASSERT_EQ(::mkfifo((root / "sys/class/drm/card0-DP-1/edid").c_str(), 0600), 0);
    const auto found = connectedMonitors(root.path()); // a pipe that nobody writes to
    ASSERT_EQ(found.size(), 1U);
    EXPECT_FALSE(found[0].edid);
    EXPECT_TRUE(found[0].modes.empty()) << "a megabyte of modes is not read";
}

} // namespace
} // namespace autostereo::test

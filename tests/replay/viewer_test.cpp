// A viewer whose eyes a tracked barrier follows, through the program alone: from a file, and as a
// head tracker sends them.

#include "tests/replay/kiosk.hpp"
#include "tests/replay/tracked_panel.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <array>
#include <cstdio>

namespace autostereo::test {
namespace {

constexpr const char* kLeftEye = "-0.11,0.02,0.6";
constexpr const char* kRightEye = "-0.047,0.02,0.6";

class ViewerTest : public testing::Test {
  protected:
    void SetUp() override {
        std::string trace;
        for (int sample = 0; sample < 120; ++sample)
            trace += std::to_string(sample / 60.0) + "," + kLeftEye + "," + kRightEye + "\n";
        static_cast<void>(panel.folder().file("trace.csv", trace));
    }
    /// A second of a room where nothing moves.
    void run(const std::string& config) { panel.run(input, config, {"--speed", "max"}); }
    TrackedPanel panel;
    const std::string input = std::string(kSmallRoom) + "&noise=off&frames=30";
};

TEST_F(ViewerTest, EachEyeOfARecordedViewerSeesItsOwnView) {
    run("");
    const double unfollowed = psnr(panel.seen(kLeftEye), panel.view(kLeftEye, 1));
    run("[viewer]\nsource = \"file:trace.csv\"\ndelay_ms = 0\n");
    const ColorPicture left = panel.seen(kLeftEye), right = panel.seen(kRightEye);
    const ColorPicture leftView = panel.view(kLeftEye), rightView = panel.view(kRightEye);
    std::printf("left eye %.1f dB (%.1f of the other's view, %.1f not followed), right %.1f dB\n",
                psnr(left, leftView), psnr(left, rightView), unfollowed, psnr(right, rightView));
    EXPECT_GT(psnr(left, leftView), psnr(left, rightView) + 3);
    EXPECT_GT(psnr(right, rightView), psnr(right, leftView) + 3);
    EXPECT_GT(psnr(left, leftView), unfollowed + 3);
}

/// A frame for a display without eyes is as good without a viewer; that is said.
TEST_F(ViewerTest, ADisplayForEverybodyFollowsNobody) {
    const auto result = runProgram(
        calling({"run", "--config",
                 panel.folder().file("viewer.toml", "[viewer]\nsource = \"file:trace.csv\"\n"),
                 "--input", input, "--display", smallDisplay(panel.folder()), "--output",
                 "offscreen", "--speed", "max"}));
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.err.find("shows the same to every eye"), std::string::npos) << result.err;
}

/// Sends opentrack's datagram: centimetres and degrees from the nominal place.
void sendHead(std::uint16_t port, const std::array<double, 6>& pose) {
    const int to = socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ASSERT_EQ(sendto(to, pose.data(), sizeof(pose), 0, reinterpret_cast<sockaddr*>(&address),
                     sizeof(address)),
              static_cast<ssize_t>(sizeof(pose)));
    close(to);
}

TEST(Viewer, AHeadTrackersViewerIsInTheStatus) {
    constexpr std::uint16_t kPort = 42'421;
    Kiosk kiosk("[viewer]\nsource = \"opentrack:" + std::to_string(kPort) +
                    "\"\ndelay_ms = 0\nlost_after_ms = 5000\nease_ms = 0\n",
                kBarrier);
    kiosk.plugBoth();
    kiosk.start();
    ASSERT_TRUE(kiosk.shows("live", std::chrono::seconds(10)));
    EXPECT_FALSE(kiosk.status().at("viewer").at("tracked").get<bool>());
    // 12 cm to the right, 5 up, 10 towards the panel: from (0, 0, 0.65) m.
    const auto there = [&] {
        sendHead(kPort, {12, 5, 10, 0, 0, 0});
        const auto viewer = kiosk.status().at("viewer");
        const auto& eyes = viewer.at("eyes_m");
        const auto near = [&](std::size_t axis, double expected) {
            const double middle =
                (eyes.at(0).at(axis).get<double>() + eyes.at(1).at(axis).get<double>()) / 2;
            return std::abs(middle - expected) < 1e-3;
        };
        return viewer.at("tracked").get<bool>() && near(0, 0.12) && near(1, 0.05) && near(2, 0.55);
    };
    EXPECT_TRUE(eventually(there, std::chrono::seconds(10 * kSlower)))
        << kiosk.status().at("viewer").dump();
    sendHead(kPort, {0, 0, 1e300, 0, 0, 0});
    EXPECT_TRUE(eventually(
        [&] { return kiosk.status().at("viewer").at("samples").at("damaged").get<int>() == 1; },
        std::chrono::seconds(5 * kSlower)));
    EXPECT_TRUE(succeeded(kiosk.stop()));
}

} // namespace
} // namespace autostereo::test

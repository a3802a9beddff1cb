// Cameras that say wrong things about themselves. The kernel's driver may refuse them or take them
// for something else; whatever it then offers is a camera or one line for us.

#include "tests/device/v4l2/uvc_fixture.hpp"
#include "tests/support/data.hpp"

#include <iostream>
#include <thread>

namespace autostereo::test {
namespace {

using namespace std::chrono_literals;

class UvcDescriptorsTest : public UvcTest {
  protected:
    struct Tally {
        int refused = 0; ///< by the kernel: no node
        int said = 0;    ///< by us, in one line
        int silent = 0;  ///< opened, but no frame came
        int streamed = 0;
    };
    /// The first node of a camera on USB; the guest has others.
    static std::string node() {
        for (const auto& node : devices::v4l2::findCameras())
            if (node.usbMbps > 0) return node.path.string();
        return "";
    }
    /// What comes of the first node that appears.
    static void tryWhatIsThere(Tally& tally) {
        const auto end = std::chrono::steady_clock::now() + 1s;
        while (node().empty() && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(5ms);
        const std::string there = node();
        if (there.empty()) {
            ++tally.refused;
            return;
        }
        try {
            Stream stream("v4l2:" + there);
            const devices::Frame frame = stream.next(300ms);
            ++(frame.empty() ? tally.silent : tally.streamed);
            if (frame.empty()) return;
            const devices::FrameMetadata& form = frame.metadata();
            EXPECT_TRUE(devices::allowsSize(form.format, form.width, form.height));
            EXPECT_EQ(frame.pixels().size(),
                      devices::frameBytes(form.format, form.width, form.height));
        } catch (const devices::DeviceError& error) {
            ++tally.said;
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        }
    }
};

TEST_F(UvcDescriptorsTest, WrongOnesAreRefusedSaidOrStreamed) {
    const unsigned cases = fullCampaign() ? 1000 : 12;
    UvcParams small = params(false);
    small.formats.resize(1); // a JPEG's decoder is tested elsewhere
    Tally tally;
    auto slowest = 0ms;
    for (unsigned seed = 1; seed <= cases; ++seed) {
        SCOPED_TRACE(seed);
        const auto started = std::chrono::steady_clock::now();
        camera.emplace(small);
        UvcFaults faults;
        faults.damagedDescriptors = seed;
        camera->setFaults(faults);
        plug = std::make_unique<usbip::Plug>(*camera, usbip::Speed::High);
        tryWhatIsThere(tally);
        plug.reset();
        ASSERT_TRUE(within2s([] { return node().empty(); })) << "a node stays";
        slowest = std::max(slowest, std::chrono::duration_cast<std::chrono::milliseconds>(
                                        std::chrono::steady_clock::now() - started));
    }
    std::cout << cases << " cameras: " << tally.refused << " refused by the kernel, " << tally.said
              << " by us, " << tally.silent << " without frames, " << tally.streamed
              << " with; slowest " << slowest.count() << " ms\n";
    EXPECT_GT(tally.streamed, 0) << "nothing was tried";
    EXPECT_GT(tally.refused + tally.said + tally.silent, 0) << "nothing was wrong";
    EXPECT_LT(slowest, 10s) << "nothing hangs";

    plugIn();
    Stream healthy("v4l2:serial=UVC0001?format=YUYV");
    EXPECT_TRUE(isWhole(healthy.next())) << healthy.lost;
}

} // namespace
} // namespace autostereo::test

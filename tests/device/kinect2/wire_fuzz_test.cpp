// Anything at all goes wrong on the bus, on both streams at once.

#include "devices/clock.hpp"
#include "tests/device/kinect2/kinect2_fixture.hpp"
#include "tests/support/data.hpp"

#include <cmath>
#include <cstdio>
#include <random>
#include <thread>

namespace autostereo::test {
namespace {

using namespace std::chrono_literals;

/// What a bus does. It neither doubles nor reorders packets: bulk ones carry toggles, isochronous
/// ones belong to their interval; and sub-images have no checksum that would tell.
usbip::Faults anyFaults(std::mt19937& random) {
    const auto chance = [&](double share) {
        return std::uniform_real_distribution(0.0, 1.0)(random) < share;
    };
    // From one packet in some frames to every third one.
    const auto share = [&] {
        return chance(0.4) ? std::pow(10, std::uniform_real_distribution(-4.5, -0.5)(random)) : 0;
    };
    usbip::Faults faults;
    faults.lose = share();
    faults.truncate = share();
    faults.stall = chance(0.01);
    faults.silent = chance(0.01);
    faults.babble = chance(0.01);
    if (chance(0.01)) faults.unplugAfter = random() % 500;
    return faults;
}

/// Whether a stream may be lost by it, which takes time to be noticed.
bool ends(const usbip::Faults& faults) {
    return faults.stall || faults.silent || faults.babble || faults.unplugAfter;
}

class WireFuzz : public Kinect2Test {
  protected:
    void open() {
        const auto end = devices::steadyNow() + 10s;
        std::string why;
        while (!input && devices::steadyNow() < end) {
            if (!plug->plugged()) plugInAgain();
            try {
                input.emplace(devices::openInput("kinect2:"));
            } catch (const devices::DeviceError& error) {
                why = error.what(); // the kernel has not let go of it, or not found it yet
                std::this_thread::sleep_for(50ms);
            }
        }
        ASSERT_TRUE(input) << why;
    }
    /// What both streams give for a while; false: one is lost.
    bool read(std::chrono::milliseconds time) {
        for (const auto end = devices::steadyNow() + time; devices::steadyNow() < end;)
            for (devices::Source* source : {input->depth.get(), input->color.get()}) {
                std::string why;
                const devices::Frame frame = nextFrame(*source, &why, 15ms);
                if (!why.empty()) return false;
                if (frame.empty()) continue;
                const bool known = expectedPictures().find(frame).has_value();
                const bool isDepth = source == input->depth.get();
                if (!known) ++(isDepth ? misreadDepths : misreadColors);
                ++(isDepth ? depths : colors);
            }
        return true;
    }

    std::optional<devices::Input> input;
    int depths = 0, colors = 0, misreadDepths = 0, misreadColors = 0;
};

TEST_F(WireFuzz, NothingIsMisreadWhateverTheWireDoes) {
    plugIn();
    static_cast<void>(expectedPictures()); // made before time counts
    std::mt19937 random(31);
    const int cases = fullCampaign() ? 10'000 : 40;
    int lost = 0;
    const auto account = [&](int count) {
        std::printf("%d cases: %d times lost and opened anew; %d depth frames, %d misread; %d "
                    "colour frames, %d misread\n",
                    count, lost, depths, misreadDepths, colors, misreadColors);
        std::fflush(stdout);
    };
    for (int i = 0; i < cases; ++i) {
        if (i % 500 == 499) account(i);
        if (!input) {
            ASSERT_NO_FATAL_FAILURE(open()) << "case " << i;
        }
        const usbip::Faults depth = anyFaults(random), color = anyFaults(random);
        setFaults(depth, color);
        const bool here = read(ends(depth) || ends(color) ? 1500ms : 30ms);
        setFaults({}, {});
        if (here) continue;
        ++lost;
        input.reset();
    }
    account(cases);
    EXPECT_EQ(misreadDepths, 0);
    EXPECT_EQ(misreadColors, 0);
    EXPECT_GT(lost, 0);
    if (!input) {
        ASSERT_NO_FATAL_FAILURE(open());
    }
    depths = colors = 0;
    EXPECT_TRUE(read(5s));
    EXPECT_GT(depths, 0) << "and afterwards all is well";
    EXPECT_GT(colors, 0);
}

} // namespace
} // namespace autostereo::test

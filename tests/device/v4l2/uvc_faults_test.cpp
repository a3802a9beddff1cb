// What goes wrong in a USB camera or on its cable, and what becomes of it.

#include "tests/device/v4l2/uvc_fixture.hpp"

#include <iostream>

namespace autostereo::test {
namespace {

using namespace std::chrono_literals;
using usbip::Faults;

const std::string kYuyv = std::string("v4l2:serial=UVC0001?format=YUYV");
const std::string kMjpg = std::string("v4l2:serial=UVC0001?format=MJPG");

class UvcFaultsTest : public UvcTest {
  protected:
    /// Reads for a while; every frame that comes must be whole. How many came.
    static int wholeFrames(Stream& stream, std::chrono::milliseconds time) {
        int count = 0;
        const auto end = std::chrono::steady_clock::now() + time;
        while (std::chrono::steady_clock::now() < end) {
            const devices::Frame frame = stream.next(500ms);
            if (frame.empty()) break;
            ++count;
            EXPECT_TRUE(isWhole(frame));
        }
        return count;
    }
    /// Opens the lost stream again.
    static bool comesBack(Stream& stream) {
        stream.source.reset();
        return within2s([&] {
                   try {
                       stream.source = stream.reopen();
                       return true;
                   } catch (const devices::DeviceError&) {
                       return false;
                   }
               }) &&
               !stream.next().empty();
    }
    static std::string openingError(const std::string& address) try {
        const Stream stream(address);
        return "";
    } catch (const devices::DeviceError& error) {
        return error.what();
    }
};

TEST_F(UvcFaultsTest, FramesWithTheErrorBitNeverArrive) {
    plugIn();
    UvcFaults faults;
    faults.errorEvery = 5;
    camera->setFaults(faults);
    Stream stream(kYuyv);
    for (int i = 0; i < 20; ++i) {
        const devices::Frame frame = stream.next();
        ASSERT_FALSE(frame.empty()) << stream.lost;
        const int number = std::to_integer<int>(frame.pixels()[0]) - UvcCamera::lumaOf(0);
        EXPECT_NE(number % 5, 0) << "frame " << number << " carried the error bit";
    }
}

TEST_F(UvcFaultsTest, HalfAPictureIsDroppedAndCounted) {
    plugIn();
    UvcFaults faults;
    faults.halfEvery = 4;
    camera->setFaults(faults);
    {
        Stream stream(kMjpg);
        for (int i = 0; i < 15; ++i)
            ASSERT_FALSE(stream.next().empty()) << stream.lost;
        // Every fourth of the twenty that it took.
        EXPECT_NEAR(static_cast<double>(stream.source->counters().damaged), 5, 1);
    }
    Stream stream(kYuyv);
    for (int i = 0; i < 15; ++i) {
        const devices::Frame frame = stream.next();
        ASSERT_FALSE(frame.empty()) << stream.lost;
        EXPECT_TRUE(isWhole(frame));
    }
}

TEST_F(UvcFaultsTest, SilenceIsFoundWithinFiveFramePeriods) {
    plugIn();
    Stream stream(kYuyv);
    ASSERT_FALSE(stream.next().empty());
    UvcFaults faults;
    faults.silentAfter = 10;
    camera->setFaults(faults);
    auto last = std::chrono::steady_clock::now();
    while (!stream.next().empty())
        last = std::chrono::steady_clock::now();
    const auto found = std::chrono::steady_clock::now() - last;
    EXPECT_NE(stream.lost.find("no frame comes any more"), std::string::npos) << stream.lost;
    std::cout << "silence found after " << std::chrono::duration<double, std::milli>(found).count()
              << " ms\n";
    EXPECT_GE(found, 5 * 33ms);
    EXPECT_LE(found, 5 * 34ms + 20ms); // 20: the guest's scheduling
    camera->setFaults({});
    EXPECT_TRUE(comesBack(stream)) << stream.lost;
}

TEST_F(UvcFaultsTest, ACameraThatNeverSendsIsGivenTwoSeconds) {
    plugIn();
    plug->setFaults(UvcCamera::kVideo, [] {
        Faults faults;
        faults.silent = true;
        return faults;
    }());
    Stream stream(kYuyv);
    const auto started = std::chrono::steady_clock::now();
    EXPECT_TRUE(stream.next(5000ms).empty());
    EXPECT_NE(stream.lost, "");
    EXPECT_NEAR(std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count(),
                2, 0.2);
}

TEST_F(UvcFaultsTest, PulledAndPluggedInAgainItIsBack) {
    plugIn();
    Stream stream(kYuyv);
    for (int i = 0; i < 3; ++i) {
        ASSERT_FALSE(stream.next().empty()) << stream.lost;
        plug->pull();
        while (!stream.next().empty()) {
        }
        EXPECT_NE(stream.lost, "");
        plugInAgain();
        EXPECT_TRUE(comesBack(stream)) << stream.lost;
    }
}

TEST_F(UvcFaultsTest, PulledInTheMiddleOfAPicture) {
    for (const std::uint64_t packets : {0U, 1U, 5U, 13U, 40U}) {
        plugIn();
        Stream stream(kMjpg);
        Faults faults;
        faults.unplugAfter = packets;
        plug->setFaults(UvcCamera::kVideo, faults);
        while (!stream.next().empty()) {
        }
        EXPECT_NE(stream.lost, "");
        stream.source.reset();
        unplug();
    }
}

TEST_F(UvcFaultsTest, BrokenPacketsMakeNoBrokenPictures) {
    for (const bool isochronous : {false, true})
        for (const auto fault : {&Faults::truncate, &Faults::duplicate, &Faults::lose}) {
            if (!isochronous && fault == &Faults::lose) continue; // ends a bulk stream: below
            plugIn(isochronous);
            Stream stream(kYuyv);
            ASSERT_FALSE(stream.next().empty()) << stream.lost;
            Faults faults;
            faults.*fault = 0.002; // a picture is 10 to 50 packets
            plug->setFaults(UvcCamera::kVideo, faults);
            EXPECT_GT(wholeFrames(stream, 1500ms), 5);
            stream.source.reset();
            unplug();
        }
}

TEST_F(UvcFaultsTest, AStreamThatTheWireEndsIsOpenedAgain) {
    plugIn();
    Stream stream(kYuyv);
    ASSERT_FALSE(stream.next().empty()) << stream.lost;
    Faults faults;
    faults.lose = 1;
    plug->setFaults(UvcCamera::kVideo, faults);
    while (!stream.next().empty()) {
    }
    EXPECT_NE(stream.lost, "");
    plug->setFaults(UvcCamera::kVideo, {});
    EXPECT_TRUE(comesBack(stream)) << stream.lost;
}

TEST_F(UvcFaultsTest, ACameraThatRefusesOrPromisesAbsurdSizesIsOneLine) {
    plugIn();
    UvcFaults faults;
    faults.refuses = true;
    camera->setFaults(faults);
    const std::string refused = openingError(kYuyv);
    EXPECT_NE(refused.find("cannot"), std::string::npos) << refused;
    faults = {};
    faults.absurdSizes = true;
    camera->setFaults(faults);
    const std::string absurd = openingError(kMjpg);
    EXPECT_NE(absurd.find("cannot"), std::string::npos) << absurd;
    camera->setFaults({});
    EXPECT_EQ(openingError(kYuyv), "");
}

TEST_F(UvcFaultsTest, ABusyOrAbsentCameraIsSaid) {
    plugIn();
    const Stream first(kYuyv);
    const std::string busy = openingError(kYuyv);
    EXPECT_NE(busy.find("busy"), std::string::npos) << busy;
    const std::string absent = openingError("v4l2:serial=other");
    EXPECT_NE(absent.find("no such camera (there are /dev/video0 'vivid-000-vid-cap', /dev/video1 "
                          "'Emulated camera'"),
              std::string::npos)
        << absent;
    const std::string mode = openingError("v4l2:serial=UVC0001?size=17x17");
    EXPECT_NE(mode.find("none of its modes fits (YUYV 320x240 30 fps"), std::string::npos) << mode;
}

} // namespace
} // namespace autostereo::test

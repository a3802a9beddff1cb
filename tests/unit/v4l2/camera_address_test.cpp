#include "devices/input.hpp"
#include "devices/v4l2/camera_address.hpp"

#include <gtest/gtest.h>

#include <linux/videodev2.h>

namespace autostereo {
namespace {

using namespace devices::v4l2;
using namespace std::chrono_literals;

CameraAddress parsed(const std::string& text) { return cameraAddress(devices::parseUri(text)); }

TEST(CameraAddress, FourWaysToNameACamera) {
    EXPECT_EQ(parsed("v4l2:").name.by, CameraName::By::First);
    EXPECT_EQ(parsed("v4l2:/dev/video3").name.by, CameraName::By::Path);
    EXPECT_EQ(parsed("v4l2:/dev/video3").name.text, "/dev/video3");
    EXPECT_EQ(parsed("v4l2:usb-0000:00:14.0-2").name.by, CameraName::By::Bus);
    EXPECT_EQ(parsed("v4l2:usb-0000:00:14.0-2").name.text, "usb-0000:00:14.0-2");
    EXPECT_EQ(parsed("v4l2:serial=AB 12").name.by, CameraName::By::Serial);
    EXPECT_EQ(parsed("v4l2:serial=AB 12").name.text, "AB 12");
}

TEST(CameraAddress, HowTheCameraIsRun) {
    const CameraAddress address =
        parsed("v4l2:?size=1920x1080&fps=15&format=MJPG&exposure_ms=8.5&power_line=50&"
               "white_balance=4600");
    EXPECT_EQ(address.mode.width, 1920);
    EXPECT_EQ(address.mode.height, 1080);
    EXPECT_EQ(address.mode.framesPerSecond, 15);
    EXPECT_EQ(address.mode.code, V4L2_PIX_FMT_MJPEG);
    EXPECT_EQ(address.role, Role::Color);
    EXPECT_EQ(address.controls.exposure, 8500us);
    EXPECT_EQ(address.controls.powerLine, PowerLine::Hz50);
    EXPECT_EQ(address.controls.whiteBalanceK, 4600);
    EXPECT_EQ(parsed("v4l2:?format=Y16").role, Role::Depth);
    EXPECT_EQ(parsed("v4l2:?as=depth&unit_mm=0.1").depthUnitM, 0.0001);
    EXPECT_FALSE(parsed("v4l2:").role);
    EXPECT_TRUE(parsed("v4l2:").zeroCopy);
    EXPECT_FALSE(parsed("v4l2:?zero_copy=off").zeroCopy);
}

std::string complaint(const std::string& query) try {
    static_cast<void>(parsed("v4l2:?" + query));
    return "";
} catch (const devices::AddressError& error) {
    return error.what();
}

TEST(CameraAddress, MistakesAreNamed) {
    EXPECT_EQ(complaint("size=big"),
              "v4l2:?size=big: size = 'big' (allowed WIDTHxHEIGHT, 1x1 to 16384x16384)");
    EXPECT_NE(complaint("size=0x10"), "");
    EXPECT_NE(complaint("size=99999x1"), "");
    EXPECT_NE(complaint("size=640x480x2"), "");
    EXPECT_EQ(complaint("as=sound"), "v4l2:?as=sound: as = 'sound' (allowed color, depth)");
    EXPECT_EQ(complaint("format=H264"), "v4l2:?format=H264: format = 'H264' (allowed NV12, YUYV, "
                                        "UYVY, RGB3, BGR3, XR24, AR24, BGR4, MJPG, JPEG, "
                                        "GREY, Z16, Y16)");
    EXPECT_NE(complaint("fps=0"), "");
    EXPECT_NE(complaint("power_line=55"), "");
    EXPECT_EQ(complaint("zero_copy=on"),
              "v4l2:?zero_copy=on: zero_copy = 'on' (allowed auto, off)");
    EXPECT_NE(complaint("colour=red"), "");
}

} // namespace
} // namespace autostereo

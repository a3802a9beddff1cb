#pragma once

#include "devices/v4l2/find_cameras.hpp"
#include "tests/device/usbip/plug.hpp"
#include "tests/device/uvc/jpeg_picture.hpp"
#include "tests/device/uvc/uvc_camera.hpp"
#include "tests/device/v4l2/reading.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>

namespace autostereo::test {

/// A camera on USB with one YUYV and one MJPEG format, found by its serial number.
class UvcTest : public testing::Test {
  protected:
    static constexpr const char* kAddress = "v4l2:serial=UVC0001";

    void SetUp() override {
        if (!usbip::Plug::possible()) GTEST_SKIP() << "no virtual USB ports: run in the guest";
    }
    void TearDown() override { unplug(); }

    static UvcParams params(bool isochronous) {
        UvcParams all;
        all.isochronous = isochronous;
        UvcFormat jpeg{UvcFormat::Kind::Mjpeg, 1920, 1080, {}};
        for (unsigned seed = 0; seed < 4; ++seed)
            jpeg.jpegs.push_back(jpegPicture(jpeg.width, jpeg.height, seed));
        UvcFormat small{UvcFormat::Kind::Yuyv, 320, 240, {}}; // fits into high speed
        all.formats = {small, jpeg};
        return all;
    }
    void plugIn(bool isochronous = false) {
        camera.emplace(params(isochronous));
        plugInAgain();
    }
    void plugInAgain() {
        plug = std::make_unique<usbip::Plug>(*camera, usbip::Speed::High);
        ASSERT_TRUE(within2s(isThere)) << "the kernel did not take the camera";
    }
    void unplug() {
        plug.reset();
        EXPECT_TRUE(within2s([] { return !isThere(); }));
    }
    static bool isThere() {
        for (const auto& node : devices::v4l2::findCameras())
            if (node.serial == "UVC0001") return true;
        return false;
    }

    std::optional<UvcCamera> camera;
    std::unique_ptr<usbip::Plug> plug;
};

/// Every luma sample is the first one's, every chroma sample neutral: as the camera makes them.
inline bool isWhole(const devices::Frame& frame) {
    const auto pixels = frame.pixels();
    for (std::size_t i = 0; i < pixels.size(); i += 2)
        if (pixels[i] != pixels[0] || pixels[i + 1] != std::byte{128}) return false;
    return !pixels.empty();
}

} // namespace autostereo::test

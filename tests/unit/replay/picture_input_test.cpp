#include "devices/input.hpp"
#include "devices/replay/image_files.hpp"
#include "tests/support/data.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/replay/playing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

namespace autostereo {
namespace {

using namespace std::chrono_literals;
using devices::DeviceError;
using devices::ImageFormat;
using devices::Input;
using devices::openInput;

std::string data(const char* relative) { return (test::dataDir() / relative).string(); }

void writePicture(const std::filesystem::path& path, ImageFormat format, int width, int height) {
    const devices::ImageHeader header{format, width, height};
    const std::vector<std::byte> pixels(header.bytes(), std::byte{100});
    devices::writePng(path, {header, pixels});
}

TEST(Tum, playsTheFilesThatAreThere) {
    AUTOSTEREO_NEED_DATA("tum-fr1-rpy/rgb.txt");
    const Input input = openInput("tum:" + data("tum-fr1-rpy"));
    const auto depth = test::nextFrame(*input.depth);
    ASSERT_TRUE(depth);
    EXPECT_EQ(depth->metadata().depthUnitM, 1.0 / 5000);
    EXPECT_EQ(depth->metadata().width, 640);
    // The first picture of either stream is at zero; the two are not in step.
    const auto color = test::nextFrame(*input.color);
    ASSERT_TRUE(color);
    const auto first = std::min(depth->metadata().capturedAt, color->metadata().capturedAt);
    EXPECT_EQ(first.time_since_epoch(), 0ns);
    EXPECT_NE(depth->metadata().capturedAt, color->metadata().capturedAt);
    EXPECT_EQ(1 + test::countFrames(*input.depth), 16);
    EXPECT_EQ(1 + test::countFrames(*input.color), 14);
    EXPECT_EQ(input.depth->counters().damaged, 0U); // the 706 missing files are not damage
    EXPECT_NEAR(std::chrono::duration<double>(input.nominalPeriod).count(), 1.0 / 30, 0.002);
}

TEST(Tum, frameTimesAreTheListed) {
    AUTOSTEREO_NEED_DATA("tum-fr1-rpy/rgb.txt");
    const Input input = openInput("tum:" + data("tum-fr1-rpy"));
    auto before = test::nextFrame(*input.depth)->metadata().capturedAt;
    while (const auto frame = test::nextFrame(*input.depth)) {
        const auto period = frame->metadata().capturedAt - before;
        EXPECT_GT(period, 15ms);
        EXPECT_LT(period, 60ms);
        before = frame->metadata().capturedAt;
    }
}

TEST(Tum, camerasAreThePublishedOnes) {
    AUTOSTEREO_NEED_DATA("tum-fr1-rpy/rgb.txt");
    const Input input = openInput("tum:" + data("tum-fr1-rpy"));
    ASSERT_TRUE(input.rig);
    EXPECT_EQ(input.rig->color.intrinsics.fx, 517.3);
    EXPECT_EQ(input.rig->color.distortion.k3, 1.1633);
    EXPECT_EQ(input.rig->depth.distortion.k1, 0.2624); // registered as it is: the same model
    EXPECT_TRUE(input.warnings.empty());
}

TEST(Tum, setIsReadFromTheFolderOrTheFileIsTaken) {
    const test::ScratchFolder scratch;
    const auto folder = scratch / "rgbd_dataset_freiburg2_xyz";
    std::filesystem::create_directories(folder / "depth");
    writePicture(folder / "depth/1.png", ImageFormat::Grey16, 640, 480);
    std::ofstream(folder / "depth.txt") << "# comment\n12.5 depth/1.png\nrubbish\n13 gone.png\n";
    const Input input = openInput("tum:" + folder.string() + "/");
    ASSERT_TRUE(input.rig);
    EXPECT_EQ(input.rig->depth.intrinsics.fx, 520.9);
    EXPECT_FALSE(input.color);
    EXPECT_EQ(test::countFrames(*input.depth), 1);

    const auto camera = scratch.write(
        "c.json", R"({"depth": {"width": 640, "height": 480, "fx": 100, "fy": 100, "cx": 1,
                      "cy": 2, "depth_scale_m": 0.01}})");
    const Input own = openInput("tum:" + folder.string() + "?camera=" + camera.string());
    EXPECT_EQ(own.rig->color.intrinsics.fx, 100.0);
    EXPECT_EQ(test::nextFrame(*own.depth)->metadata().depthUnitM, 0.01);
    EXPECT_THROW(static_cast<void>(openInput("tum:" + scratch.path().string())), DeviceError);
}

TEST(Sequence, redkitchen) {
    AUTOSTEREO_NEED_DATA("rgbd-redkitchen/frame-000000.color.jpg");
    const Input input = openInput("seq:" + data("rgbd-redkitchen"));
    ASSERT_EQ(input.warnings.size(), 1U); // nominal camera
    ASSERT_TRUE(input.rig);
    EXPECT_EQ(input.rig->depth.intrinsics.width, 640);
    EXPECT_NEAR(input.rig->color.intrinsics.fx, 0.82 * 640, 1e-9);
    EXPECT_EQ(test::countFrames(*input.depth), 90);
    EXPECT_EQ(test::countFrames(*input.color), 90);
    EXPECT_EQ(input.depth->counters().damaged + input.color->counters().damaged, 0U);
    EXPECT_EQ(input.nominalPeriod, 33'333'333ns);
}

TEST(Sequence, deskPerson) {
    AUTOSTEREO_NEED_DATA("rgbd-desk-person/00000.jpg");
    const Input input = openInput("seq:" + data("rgbd-desk-person") + "?fps=15");
    const auto depth = test::nextFrame(*input.depth);
    ASSERT_TRUE(depth);
    EXPECT_EQ(depth->metadata().width, 640);
    EXPECT_EQ(depth->metadata().height, 360);
    EXPECT_EQ(depth->metadata().depthUnitM, 0.001);
    EXPECT_EQ(test::nextFrame(*input.depth)->metadata().capturedAt.time_since_epoch(),
              66'666'667ns);
    EXPECT_EQ(2 + test::countFrames(*input.depth), 40);
    EXPECT_EQ(test::countFrames(*input.color), 40);
}

TEST(Sequence, gapsKeepTheirTime) {
    const test::ScratchFolder folder;
    for (const char* name : {"7.png", "9.png"})
        writePicture(folder / name, ImageFormat::Grey16, 8, 6);
    const Input input = openInput("seq:" + folder.path().string() + "?fps=10");
    EXPECT_FALSE(input.color); // depth alone
    EXPECT_EQ(test::nextFrame(*input.depth)->metadata().capturedAt.time_since_epoch(), 0ms);
    EXPECT_EQ(test::nextFrame(*input.depth)->metadata().capturedAt.time_since_epoch(), 200ms);
}

TEST(Sequence, colourAloneGivesItsCameraToBoth) {
    const test::ScratchFolder folder;
    writePicture(folder / "1.png", ImageFormat::Rgb8, 8, 6);
    const Input input = openInput("seq:" + folder.path().string());
    EXPECT_FALSE(input.depth);
    ASSERT_TRUE(input.color && input.rig);
    EXPECT_EQ(input.rig->depth.intrinsics.width, 8);
    EXPECT_EQ(test::countFrames(*input.color), 1);
}

TEST(Sequence, wrongSizesAndRubbishAreDroppedAndCounted) {
    const test::ScratchFolder folder;
    writePicture(folder / "frame-0.depth.png", ImageFormat::Grey16, 8, 6);
    writePicture(folder / "frame-1.depth.png", ImageFormat::Grey16, 6, 8);
    writePicture(folder / "frame-2.depth.png", ImageFormat::Rgb8, 8, 6);
    folder.write("frame-3.depth.png", "rubbish");
    writePicture(folder / "frame-4.depth.png", ImageFormat::Grey16, 8, 6);
    const Input input = openInput("seq:" + folder.path().string());
    EXPECT_EQ(test::countFrames(*input.depth), 2);
    EXPECT_EQ(input.depth->counters().damaged, 3U);
    EXPECT_EQ(input.depth->counters().delivered, 2U);
}

TEST(Sequence, theCameraFileDecidesTheSize) {
    const test::ScratchFolder folder;
    writePicture(folder / "frame-0.depth.png", ImageFormat::Grey16, 8, 6);
    writePicture(folder / "frame-1.depth.png", ImageFormat::Grey16, 16, 12);
    folder.write("camera.json", R"({"depth": {"width": 16, "height": 12, "fx": 10, "fy": 10,
                                    "cx": 8, "cy": 6, "depth_scale_m": 0.002}})");
    const Input input = openInput("seq:" + folder.path().string());
    EXPECT_EQ(input.warnings.size(), 1U);
    const auto frame = test::nextFrame(*input.depth);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->metadata().width, 16);
    EXPECT_EQ(frame->metadata().sequence, 1U);
    EXPECT_EQ(frame->metadata().depthUnitM, 0.002);
    EXPECT_EQ(input.depth->counters().damaged, 1U);
    EXPECT_EQ(input.rig->depth.intrinsics.fx, 10.0);
}

TEST(Sequence, nothingReadableEndsAfterCounting) {
    const test::ScratchFolder folder;
    folder.write("1.jpg", "rubbish");
    const Input input = openInput("seq:" + folder.path().string());
    EXPECT_EQ(test::countFrames(*input.color), 0);
    EXPECT_EQ(input.color->counters().damaged, 1U);
    EXPECT_TRUE(input.color->rewind());
}

TEST(Sequence, emptyFolderIsAnError) {
    const test::ScratchFolder folder;
    try {
        static_cast<void>(openInput("seq:" + folder.path().string()));
        FAIL() << "opened";
    } catch (const DeviceError& error) {
        EXPECT_TRUE(error.notFound());
        EXPECT_NE(std::string(error.what()).find("no pictures found"), std::string::npos);
    }
}

TEST(Rgbd, pictureAndCameraMayBeLeftOut) {
    AUTOSTEREO_NEED_DATA("k4a-mug/color.jpg");
    const auto mug = [](const char* file) { return data("k4a-mug/") + file; };
    const Input all =
        openInput("rgbd:" + mug("color.jpg") + "," + mug("depth.png") + "," + mug("camera.json"));
    EXPECT_TRUE(all.warnings.empty());
    EXPECT_EQ(all.rig->depth.intrinsics.width, 640);
    EXPECT_EQ(test::nextFrame(*all.color)->metadata().width, 1280);
    EXPECT_EQ(test::nextFrame(*all.depth)->metadata().height, 576);

    const Input pair = openInput("rgbd:" + mug("color.jpg") + "," + mug("depth.png"));
    EXPECT_EQ(pair.warnings.size(), 1U);
    EXPECT_EQ(pair.rig->depth.intrinsics.width, 640);

    EXPECT_FALSE(openInput("rgbd:" + mug("color.jpg")).depth);
    EXPECT_FALSE(openInput("rgbd:," + mug("depth.png")).color);
    EXPECT_THROW(static_cast<void>(openInput("rgbd:,,")), DeviceError);
    EXPECT_THROW(static_cast<void>(openInput("rgbd:a,b,c,d")), DeviceError);
    EXPECT_THROW(static_cast<void>(openInput("rgbd:/no/such.png")), DeviceError);
}

} // namespace
} // namespace autostereo

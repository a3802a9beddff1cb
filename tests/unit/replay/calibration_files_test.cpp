#include "devices/input.hpp"
#include "devices/replay/calibration_files.hpp"
#include "devices/replay/image_files.hpp"
#include "tests/support/data.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace autostereo {
namespace {

using devices::readCameraFile;
using devices::readKinectCalibration;

// camera.json was made in double from the same blob: only the last digits of its text differ.
constexpr double kSame = 1e-6;

void expectSame(const calib::CameraModel& a, const calib::CameraModel& b) {
    EXPECT_EQ(a.intrinsics.width, b.intrinsics.width);
    EXPECT_EQ(a.intrinsics.height, b.intrinsics.height);
    EXPECT_NEAR(a.intrinsics.fx, b.intrinsics.fx, kSame);
    EXPECT_NEAR(a.intrinsics.fy, b.intrinsics.fy, kSame);
    EXPECT_NEAR(a.intrinsics.cx, b.intrinsics.cx, kSame);
    EXPECT_NEAR(a.intrinsics.cy, b.intrinsics.cy, kSame);
    const calib::Distortion &k = a.distortion, &l = b.distortion;
    EXPECT_NEAR(k.k1, l.k1, kSame);
    EXPECT_NEAR(k.k2, l.k2, kSame);
    EXPECT_NEAR(k.p1, l.p1, kSame);
    EXPECT_NEAR(k.p2, l.p2, kSame);
    EXPECT_NEAR(k.k3, l.k3, kSame);
    EXPECT_NEAR(k.k4, l.k4, kSame);
    EXPECT_NEAR(k.k5, l.k5, kSame);
    EXPECT_NEAR(k.k6, l.k6, kSame);
    if (std::isinf(k.metricRadius))
        EXPECT_EQ(k.metricRadius, l.metricRadius);
    else
        EXPECT_NEAR(k.metricRadius, l.metricRadius, kSame);
}

calib::SensorRig factoryRig(const char* file, devices::PictureSize depth,
                            devices::PictureSize color) {
    const auto path = test::dataDir() / file;
    return readKinectCalibration(devices::readFile(path, 1U << 20U), path.string(), depth, color);
}

TEST(KinectCalibration, equalsCameraFileOfTheSameUnit) {
    AUTOSTEREO_NEED_DATA("k4a-mug/calibration.raw.json");
    const auto rig = factoryRig("k4a-mug/calibration.raw.json", {640, 576}, {1280, 720});
    const auto file = readCameraFile(test::dataDir() / "k4a-mug/camera.json");
    ASSERT_TRUE(file.depth && file.color);
    EXPECT_EQ(file.depthUnitM, 0.001);
    expectSame(rig.depth, *file.depth);
    expectSame(rig.color, *file.color);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(rig.colorFromDepth.translation[i], file.colorFromDepth.translation[i], kSame);
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(rig.colorFromDepth.rotation[i][j], file.colorFromDepth.rotation[i][j],
                        kSame);
    }
    // Rows as in the file, so a transposed reading shows: the camera looks down by 5 degrees.
    EXPECT_NEAR(rig.colorFromDepth.rotation[2][1], 0.0861603, kSame);
}

TEST(KinectCalibration, everyModeIsACutOfTheSameFrame) {
    AUTOSTEREO_NEED_DATA("camera-calibrations/azure-kinect-a.json");
    const char* file = "camera-calibrations/azure-kinect-a.json"; // with BOM, older model
    const auto full = factoryRig(file, {1024, 1024}, {4096, 3072});
    EXPECT_NEAR(full.depth.intrinsics.fx, 0.493516743183136 * 1024, kSame);
    EXPECT_NEAR(full.depth.distortion.metricRadius, 1.7389928082607931, kSame);
    EXPECT_NEAR(full.color.intrinsics.cx, 0.50639921426773071 * 4096 - 0.5, kSame);

    const auto narrow = factoryRig(file, {640, 576}, {1920, 1080});
    EXPECT_NEAR(narrow.depth.intrinsics.cx, full.depth.intrinsics.cx - 192, kSame);
    EXPECT_NEAR(narrow.depth.intrinsics.cy, full.depth.intrinsics.cy - 180, kSame);
    // Binning and the colour modes scale about the image's edges.
    const auto binned = factoryRig(file, {320, 288}, {1280, 720});
    expectSame(binned.depth, narrow.depth.resized(320, 288));
    expectSame(binned.color, narrow.color.resized(1280, 720));
    expectSame(factoryRig(file, {512, 512}, {2560, 1440}).depth, full.depth.resized(512, 512));
    expectSame(factoryRig(file, {512, 512}, {2560, 1440}).color, narrow.color.resized(2560, 1440));
    expectSame(factoryRig(file, {640, 576}, {3840, 2160}).color, narrow.color.resized(3840, 2160));
    expectSame(factoryRig(file, {640, 576}, {2048, 1536}).color, full.color.resized(2048, 1536));
}

TEST(KinectCalibration, oneStreamGivesItsCameraToBoth) {
    AUTOSTEREO_NEED_DATA("camera-calibrations/azure-kinect-b.json");
    const char* file = "camera-calibrations/azure-kinect-b.json";
    const auto depth = factoryRig(file, {640, 576}, {});
    expectSame(depth.color, depth.depth);
    EXPECT_EQ(depth.colorFromDepth.translation, glm::dvec3(0.0));
    EXPECT_EQ(factoryRig(file, {}, {1280, 720}).depth.intrinsics.width, 1280);
    EXPECT_THROW(static_cast<void>(factoryRig(file, {100, 100}, {1280, 720})),
                 devices::DeviceError);
}

const std::string kGood = R"({"depth": {"width": 640, "height": 480, "fx": 500, "fy": 501,
    "cx": 319.5, "cy": 239.5, "depth_scale_m": 0.0002}})";

std::string errorOf(const std::string& text) {
    const test::ScratchFolder folder;
    const auto path = folder.write("camera.json", text);
    try {
        static_cast<void>(readCameraFile(path));
    } catch (const devices::DeviceError& error) {
        std::string what = error.what();
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
        EXPECT_EQ(what.rfind(path.string() + ": ", 0), 0U) << what;
        return what.substr(path.string().size() + 2);
    }
    return "";
}

std::string with(const std::string& from, const std::string& to) {
    std::string text = kGood;
    text.replace(text.find(from), from.size(), to);
    return text;
}

TEST(CameraFile, depthBlockAloneServesBoth) {
    const test::ScratchFolder folder;
    const auto file = readCameraFile(folder.write("camera.json", kGood));
    EXPECT_FALSE(file.color);
    EXPECT_EQ(file.depthUnitM, 0.0002);
    expectSame(file.rig().color, file.rig().depth);
    EXPECT_EQ(file.rig().depth.distortion.k1, 0.0);
    EXPECT_EQ(file.rig().depth.intrinsics.fy, 501.0);
}

TEST(CameraFile, open3dSchema) {
    AUTOSTEREO_NEED_DATA("rgbd-misc/redwood/camera_primesense.json");
    const auto file = readCameraFile(test::dataDir() / "rgbd-misc/redwood/camera_primesense.json");
    ASSERT_TRUE(file.color);
    EXPECT_EQ(file.color->intrinsics.fx, 525.0);
    EXPECT_EQ(file.color->intrinsics.cx, 319.5);
    EXPECT_EQ(file.color->intrinsics.cy, 239.5);
    EXPECT_EQ(file.color->intrinsics.height, 480);
}

TEST(CameraFile, complaintsNameTheKey) {
    EXPECT_EQ(errorOf(kGood), "");
    EXPECT_EQ(errorOf(with("\"fx\": 500", "\"fx\": 0")), "depth.fx = 0 (allowed a number > 0)");
    EXPECT_EQ(errorOf(with("\"fx\": 500,", "")), "depth.fx: missing (a number is needed)");
    EXPECT_EQ(errorOf(with("\"fx\": 500", "\"fx\": \"NaN\"")), "depth.fx: is no number");
    EXPECT_EQ(errorOf(with("640", "100000")), "depth.width: is 100000 (allowed 1 to 16384)");
    EXPECT_EQ(errorOf(with("640", "0")), "depth.width: is 0 (allowed 1 to 16384)");
    EXPECT_EQ(errorOf(with("640", "-1")), "depth.width: is -1 (allowed 1 to 16384)");
    EXPECT_EQ(errorOf(with("640", "640.5")), "depth.width: is 640.5 (allowed 1 to 16384)");
    EXPECT_EQ(errorOf(with("0.0002", "0")), "depth.depth_scale_m: out of range (allowed 0 to 1 m)");
    EXPECT_EQ(errorOf("{}"), "depth: missing, and so is color (one of them is needed)");
    EXPECT_EQ(errorOf("[]"), "depth: missing, and so is color (one of them is needed)");
    EXPECT_EQ(errorOf(R"({"depth": 3})"), "depth.width: missing (a number is needed)");
}

TEST(CameraFile, whatIsNoJsonIsSaidSo) {
    // JSON has no NaN and no number beyond a double's: both end in the parser.
    for (const std::string& text :
         {with("500", "NaN"), with("500", "1e999"), std::string("{"), std::string(),
          std::string("\xff\xfe\x00", 3), std::string(100'000, '[')})
        EXPECT_EQ(errorOf(text).rfind("not valid JSON: ", 0), 0U) << text.substr(0, 100);
}

TEST(CameraFile, listsAndPosesAreChecked) {
    const auto extended = [](const std::string& more) { return with("}}", "}, " + more + "}"); };
    EXPECT_EQ(errorOf(with("\"fx\"", "\"distortion_k1k2p1p2k3k4k5k6\": [1, 2], \"fx\"")),
              "depth.distortion_k1k2p1p2k3k4k5k6: wrong list (allowed 8 numbers)");
    EXPECT_EQ(errorOf(extended(R"("depth_to_color": {"t_m": [0, 0, 0]})")),
              "depth_to_color.R_rowmajor: missing (9 numbers are needed)");
    EXPECT_EQ(errorOf(extended(
                  R"("depth_to_color": {"R_rowmajor": [2,0,0,0,1,0,0,0,1], "t_m": [0,0,0]})")),
              "depth_to_color.rotation: is no rotation (allowed orthonormal rows)");
    EXPECT_EQ(errorOf(extended(
                  R"("depth_to_color": {"R_rowmajor": [-1,0,0,0,1,0,0,0,1], "t_m": [0,0,0]})")),
              "depth_to_color.rotation: is a mirror image");
    EXPECT_EQ(errorOf(extended(
                  R"("depth_to_color": {"R_rowmajor": [1,0,0,0,1,0,0,0,1], "t_m": [0,"x",0]})")),
              "depth_to_color.t_m: wrong list (allowed 3 numbers)");
}

} // namespace
} // namespace autostereo

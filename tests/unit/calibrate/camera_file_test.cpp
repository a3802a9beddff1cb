#include "calib/solve/camera_file.hpp"
#include "calib/solve/opencv_yaml.hpp"
#include "calib/solve/refusal.hpp"

#include <gtest/gtest.h>

#include <string>

namespace autostereo::calibrate {
namespace {

constexpr const char* kRos = R"(image_width: 640
image_height: 480
camera_name: head
camera_matrix:
  rows: 3
  cols: 3
  data: [525.5, 0, 319.5, 0, 526.25, 239.5, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [0.1, -0.2, 0.001, -0.002, 0.05]
)";

std::string with(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

/// What is wrong with a text, or nothing.
std::string refusal(const std::string& text, PictureSize size = {}) {
    try {
        static_cast<void>(readCameraFile(text, "f.yaml", size, 1));
        return {};
    } catch (const Refusal& why) {
        return why.what();
    }
}

TEST(CameraFile, ReadsWhatWeWriteForOpenCv) {
    calib::CameraModel depth{{640, 576, 504.25, 505.5, 320.125, 321.5}, {}};
    depth.distortion = {0.1, 0.2, 0.3e-3, 0.4e-3, 0.5, 0.6, 0.7, 0.8};
    const calib::CameraModel color{{1280, 720, 612, 613, 639, 359}, {}};
    calib::RigidTransform transform;
    transform.rotation = glm::dmat3(0, 1, 0, -1, 0, 0, 0, 0, 1);
    transform.translation = {-0.032, 0.001, 0.25};
    const CameraFile read = readCameraFile(openCvYaml(depth, color, transform), "rig.yml", {}, 1);
    ASSERT_TRUE(read.first && read.second && read.secondFromFirst);
    EXPECT_EQ(read.first->intrinsics.width, 640);
    EXPECT_EQ(read.first->intrinsics.fy, 505.5);
    EXPECT_EQ(read.first->distortion.k6, 0.8);
    EXPECT_EQ(read.second->intrinsics.height, 720);
    EXPECT_EQ(read.second->intrinsics.cx, 639);
    EXPECT_EQ(read.secondFromFirst->rotation, transform.rotation);
    EXPECT_EQ(read.secondFromFirst->translation, transform.translation);
}

TEST(CameraFile, ReadsRos) {
    const CameraFile read = readCameraFile(kRos, "head.yaml", {}, 1);
    ASSERT_TRUE(read.first);
    EXPECT_EQ(read.first->intrinsics.height, 480);
    EXPECT_EQ(read.first->intrinsics.fx, 525.5);
    EXPECT_EQ(read.first->intrinsics.cy, 239.5);
    EXPECT_EQ(read.first->distortion.p2, -0.002);
    EXPECT_EQ(read.first->distortion.k3, 0.05);
    EXPECT_FALSE(read.second || read.secondFromFirst);
}

TEST(CameraFile, TranslationsHaveAUnit) {
    const std::string pose = "%YAML:1.0\n---\nR: [1, 0, 0, 0, 1, 0, 0, 0, 1]\nT: [-52, 1, 0]\n";
    EXPECT_DOUBLE_EQ(readCameraFile(pose, "pose.yml", {}, 1e-3).secondFromFirst->translation.x,
                     -0.052);
    EXPECT_NE(refusal(pose).find("millimetres"), std::string::npos);
}

TEST(CameraFile, SaysWhatIsWrong) {
    const auto names = [](const std::string& why, const std::string& what) {
        EXPECT_NE(why.find(what), std::string::npos) << why;
        EXPECT_NE(why.find("f.yaml: "), std::string::npos) << why;
    };
    names(refusal(""), "");
    names(refusal("nonsense"), "");
    names(refusal("%YAML:1.0\n---\na: [1"), "");
    names(refusal("<?xml version=\"1.0\"?><opencv_storage><a>"), "");
    names(refusal("{\"a\": 1}"), "camera_matrix: missing");
    names(refusal(with(kRos, "image_width: 640\n", "")), "image_width: missing");
    names(refusal(with(kRos, "640", "99999")), "out of range");
    names(refusal(with(kRos, "525.5", ".Nan")), "finite");
    names(refusal(with(kRos, "525.5", "-5")), "fx");
    names(refusal(with(kRos, "525.5, 0", "525.5, 3")), "no camera matrix");
    names(refusal(with(kRos, "525.5, 0, ", "")), "7 numbers (allowed 9)");
    names(refusal(with(kRos, "525.5", "many")), "no number");
    names(refusal(with(kRos, "plumb_bob", "equidistant")), "equidistant is not known");
    names(refusal(with(kRos, "0.05]", "0.05, 0, 0, 0, 0.1]")), "thin-prism");
    names(refusal(std::string(kRos) + "R: [2, 0, 0, 0, 1, 0, 0, 0, 1]\nT: [0, 0, 0]\n"),
          "no rotation");
}

} // namespace
} // namespace autostereo::calibrate

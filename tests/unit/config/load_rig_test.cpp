#include "config/load.hpp"
#include "tests/support/data.hpp"
#include "tests/unit/config/temp_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace autostereo::config {
namespace {

constexpr const char* kRig = R"(provenance = "calibrated on the bench"
[depth]
width = 640
height = 576
fx = 504.5
fy = 504.25
cx = 332.75
cy = 348.5
distortion = { k1 = 0.5, k2 = -0.25, p1 = 1e-4, p2 = -2e-4, k3 = 0.125, k4 = 1, k5 = 2, k6 = 3, metric_radius = 1.5 }
[color]
width = 1280
height = 720
fx = 612
fy = 611
cx = 639
cy = 365
[color_from_depth]
rotation = [1, 0, 0, 0, 0.8, 0.6, 0, -0.6, 0.8]
translation_m = [-0.032, -0.002, 0.004]
)";

class LoadRig : public test::TempFolder {};

TEST_F(LoadRig, everyNumberArrives) {
    write("rig.toml", kRig);
    const calib::SensorRig rig = loadRig("rig.toml");
    EXPECT_EQ(rig.provenance, "calibrated on the bench");
    EXPECT_EQ(rig.depth.intrinsics.width, 640);
    EXPECT_EQ(rig.depth.intrinsics.height, 576);
    EXPECT_EQ(rig.depth.intrinsics.fx, 504.5);
    EXPECT_EQ(rig.depth.intrinsics.fy, 504.25);
    EXPECT_EQ(rig.depth.intrinsics.cx, 332.75);
    EXPECT_EQ(rig.depth.intrinsics.cy, 348.5);
    const calib::Distortion& k = rig.depth.distortion;
    EXPECT_EQ(k.k1, 0.5);
    EXPECT_EQ(k.k2, -0.25);
    EXPECT_EQ(k.p1, 1e-4);
    EXPECT_EQ(k.p2, -2e-4);
    EXPECT_EQ(k.k3, 0.125);
    EXPECT_EQ(k.k4, 1);
    EXPECT_EQ(k.k5, 2);
    EXPECT_EQ(k.k6, 3);
    EXPECT_EQ(k.metricRadius, 1.5);
    EXPECT_EQ(rig.color.intrinsics.width, 1280);
    EXPECT_EQ(rig.color.distortion.k1, 0);
    EXPECT_TRUE(std::isinf(rig.color.distortion.metricRadius));
    EXPECT_EQ(rig.colorFromDepth.translation, glm::dvec3(-0.032, -0.002, 0.004));
}

// Rows in the file, columns in the matrix: the y axis turns towards -z.
TEST_F(LoadRig, rotationIsRowMajor) {
    write("rig.toml", kRig);
    const glm::dvec3 turned = loadRig("rig.toml").colorFromDepth.rotation * glm::dvec3(0, 1, 0);
    EXPECT_EQ(turned, glm::dvec3(0, 0.8, -0.6));
}

TEST_F(LoadRig, exampleIsAWorkingRig) {
    const calib::SensorRig rig = exampleRig();
    EXPECT_EQ(calib::problemWith(rig.depth), std::nullopt);
    EXPECT_EQ(calib::problemWith(rig.color), std::nullopt);
    EXPECT_EQ(rig.depth.intrinsics.width, 640);
    EXPECT_EQ(rig.color.intrinsics.width, 1280);
    // The colour camera sits 32 mm to the right of the depth camera.
    EXPECT_EQ(rig.colorFromDepth.inverse() * glm::dvec3(0), glm::dvec3(0.032, 0, 0));
    EXPECT_FALSE(rig.provenance.empty());
}

TEST_F(LoadRig, cameraJsonIsARigToo) {
    AUTOSTEREO_NEED_DATA("k4a-mug/camera.json");
    const calib::SensorRig rig = loadRig(test::dataDir() / "k4a-mug/camera.json");
    EXPECT_EQ(rig.depth.intrinsics.width, 640);
    EXPECT_EQ(rig.color.intrinsics.fx, 611.7953491210938);
    EXPECT_EQ(rig.colorFromDepth.translation.x, -0.032083429396152496);
}

TEST_F(LoadRig, malformedJsonIsAConfigError) {
    write("camera.json", "{ \"depth\": { \"width\": 0 } }");
    EXPECT_THAT(test::messageOf<ConfigError>([] { (void)loadRig("camera.json"); }),
                ::testing::StartsWith("camera.json: depth.width: "));
    EXPECT_THAT(test::messageOf<ConfigError>([] { (void)loadRig("no.json"); }),
                ::testing::HasSubstr("no.json: No such file or directory"));
}

struct MalformedRig {
    const char* from;
    const char* to;
    const char* message;
};

constexpr MalformedRig kMalformedRigs[] = {
    {"", "",
     "x.toml:1:1: color.cx: missing, wanted a number (allowed -1000000 to "
     "1000000)"},
    {"fx = 504.5", "fx = 0", "x.toml:5:6: depth.fx: 0 is out of range (allowed 1 to 1000000)"},
    {"fx = 504.5\n", "",
     "x.toml:2:1: depth.fx: missing, wanted a number (allowed 1 "
     "to 1000000)"},
    {"cx = 332.75", "cx = nan",
     "x.toml:7:6: depth.cx: nan is no finite number "
     "(allowed -1000000 to 1000000)"},
    {"width = 640", "width = 640.0",
     "x.toml:3:9: depth.width: is a floating-point "
     "number, wanted an integer (allowed 1 to "
     "16384)"},
    {"k6 = 3", "k7 = 3", "x.toml:9:89: depth.distortion.k7: unknown key (did you mean k1?)"},
    {"k1 = 0.5", "k1 = '0.5'",
     "x.toml:9:21: depth.distortion.k1: is a string, "
     "wanted a number (allowed -1000 to 1000)"},
    {"provenance = \"calibrated on the bench\"\n", "",
     "x.toml:1:1: provenance: missing, wanted a string"},
    {"0.8, 0.6", "0.9, 0.6",
     "x.toml:18:12: color_from_depth.rotation: is no rotation "
     "(allowed orthonormal rows within 0.001, determinant "
     "+1)"},
    // A mirror: orthonormal, but no camera can be turned so.
    {"[1, 0, 0, 0", "[-1, 0, 0, 0",
     "x.toml:18:12: color_from_depth.rotation: is no "
     "rotation (allowed orthonormal rows within "
     "0.001, determinant +1)"},
    {"-0.032, -0.002, 0.004", "-32, -2, 4",
     "x.toml:19:18: color_from_depth.translation_m: -32 is out of range (allowed -10 "
     "to 10)"},
    {"rotation = [1, 0,", "rotation = [1,",
     "x.toml:18:12: color_from_depth.rotation: has 8 elements, wanted an array of 9 "
     "numbers (allowed -1.001 to 1.001)"}};

TEST_F(LoadRig, malformedSaysWhatAndWhere) {
    for (const MalformedRig& bad : kMalformedRigs) {
        write("x.toml", test::edited(kRig, bad.from, bad.to));
        EXPECT_EQ(test::messageOf<ConfigError>([] { (void)loadRig("x.toml"); }), bad.message);
    }
}

} // namespace
} // namespace autostereo::config

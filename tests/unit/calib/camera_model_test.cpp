#include "calib/camera_model.hpp"
#include "tests/unit/calib/random_numbers.hpp"

#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace autostereo::calib {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

CameraModel plainCamera() { return {{640, 480, 500, 510, 320.5, 239.25}, {}}; }

CameraModel barrelCamera() {
    CameraModel camera = plainCamera();
    camera.distortion.k1 = -0.3; // r (1 - 0.3 r^2) turns back at r = 1.054, where it is 0.7027
    return camera;
}

/// The k4a-mug recording's colour camera: large terms that nearly cancel.
CameraModel kinectColorCamera() {
    CameraModel camera{{1280, 720, 607.05, 606.91, 638.96, 364.91}, {}};
    camera.distortion = {0.512, -2.734, 0.000642, -0.000295, 1.594, 0.389, -2.553, 1.519, 1.7};
    return camera;
}

std::vector<cv::Point2d> projectedByOpenCv(const CameraModel& camera,
                                           const std::vector<cv::Point3d>& points) {
    const Intrinsics& i = camera.intrinsics;
    const Distortion& k = camera.distortion;
    const cv::Matx33d pinhole(i.fx, 0, i.cx, 0, i.fy, i.cy, 0, 0, 1);
    const std::vector<double> terms{k.k1, k.k2, k.p1, k.p2, k.k3, k.k4, k.k5, k.k6};
    std::vector<cv::Point2d> pixels;
    cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), pinhole, terms, pixels);
    return pixels;
}

/// Determinant of the model's derivative, by differences; not above 0 where it folds back.
double determinantAt(const Distortion& k, const glm::dvec2& at) {
    constexpr double kStep = 1e-6;
    const glm::dvec2 along = (distort(k, at + glm::dvec2{kStep, 0}) - distort(k, at)) / kStep;
    const glm::dvec2 down = (distort(k, at + glm::dvec2{0, kStep}) - distort(k, at)) / kStep;
    return along.x * down.y - along.y * down.x;
}

/// How far from the axis (z = 1 plane, at most 1) the model stays one to one.
double clearRadius(const Distortion& k) {
    for (double r = 0; r < 1; r += 0.01)
        for (double angle = 0; angle < 2 * std::numbers::pi; angle += 0.1)
            if (!(determinantAt(k, {r * std::cos(angle), r * std::sin(angle)}) > 0.1))
                return std::max(r - 0.01, 0.01);
    return 1;
}

TEST(CameraModel, ProjectsAsOpenCvDoes) {
    RandomNumbers random(1);
    for (int round = 0; round < 200; ++round) {
        const CameraModel camera = round == 0 ? kinectColorCamera() : random.camera(1);
        std::vector<cv::Point3d> points;
        for (int i = 0; i < 50; ++i) {
            const double z = random.between(0.2, 10);
            points.emplace_back(z * random.between(-0.8, 0.8), z * random.between(-0.6, 0.6), z);
        }
        const auto expected = projectedByOpenCv(camera, points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto pixel = camera.project({points[i].x, points[i].y, points[i].z});
            ASSERT_TRUE(pixel);
            // Pixels up to some thousand, in double: 1e-12 of rounding per operation.
            ASSERT_NEAR(pixel->x, expected[i].x, 1e-9) << "camera " << round;
            ASSERT_NEAR(pixel->y, expected[i].y, 1e-9) << "camera " << round;
        }
    }
}

TEST(CameraModel, UnprojectUndoesProject) {
    RandomNumbers random(2);
    for (int round = 0; round < 500; ++round) {
        CameraModel camera = round == 0 ? kinectColorCamera() : random.camera(1);
        if (round > 0) camera.distortion.metricRadius = clearRadius(camera.distortion);
        const double radius = std::min(camera.distortion.metricRadius, 1.5);
        for (int i = 0; i < 50; ++i) {
            const double r = radius * random.between(0, 0.999);
            const double angle = random.between(0, 2 * std::numbers::pi);
            const glm::dvec2 ray{r * std::cos(angle), r * std::sin(angle)};
            const auto pixel = camera.project({2 * ray.x, 2 * ray.y, 2});
            ASSERT_TRUE(pixel);
            const auto back = camera.unproject(*pixel);
            ASSERT_TRUE(back) << "camera " << round << ", r = " << r << " of " << radius;
            // Newton stops at 1e-12 on the bent plane; the slope of a tenth allows ten times that.
            ASSERT_NEAR(back->x, ray.x, 1e-9) << "camera " << round;
            ASSERT_NEAR(back->y, ray.y, 1e-9) << "camera " << round;
        }
    }
}

TEST(CameraModel, NothingIsSeenBeyondTheMetricRadius) {
    CameraModel camera = plainCamera();
    camera.distortion.metricRadius = 0.5;
    EXPECT_TRUE(camera.project({0.499, 0, 1}));
    EXPECT_FALSE(camera.project({0.501, 0, 1}));
    EXPECT_FALSE(camera.project({0.36, 0.36, 1}));
    EXPECT_TRUE(camera.unproject({320.5 + 0.499 * 500, 239.25}));
    EXPECT_FALSE(camera.unproject({320.5 + 0.501 * 500, 239.25}));
    EXPECT_FALSE(camera.unproject({320.5 + 0.36 * 500, 239.25 - 0.36 * 510}));
}

TEST(CameraModel, NothingIsSeenBehindTheCamera) {
    const CameraModel camera = plainCamera();
    for (const double z : {0.0, -0.0, -1e-9, -2.0, kNotANumber})
        EXPECT_FALSE(camera.project({0.1, 0.1, z})) << z;
    EXPECT_FALSE(camera.project({kNotANumber, 0, 1}));
    EXPECT_FALSE(camera.project({0, kInfinity, 1}));
    EXPECT_FALSE(camera.project({1e300, 0, 1e-300}));
    EXPECT_TRUE(camera.project({0, 0, 1e-9}));
    EXPECT_FALSE(camera.unproject({kNotANumber, 0}));
    EXPECT_FALSE(camera.unproject({0, kInfinity}));
}

TEST(CameraModel, WhereTheModelFoldsBackPixelsHaveNoRay) {
    const CameraModel camera = barrelCamera();
    constexpr double kTurn = 0.7027; // the farthest that any ray is seen from the centre
    for (double bent = 0.005; bent < 5; bent += 0.001) {
        const auto ray = camera.unproject({320.5 + 500 * 0.6 * bent, 239.25 + 510 * 0.8 * bent});
        if (bent > kTurn + 0.001) {
            EXPECT_FALSE(ray) << bent;
        } else if (bent < kTurn - 0.001) {
            ASSERT_TRUE(ray) << bent;
            EXPECT_LT(glm::length(*ray), 1.054) << bent;
            EXPECT_GT(ray->x, 0) << bent;
        }
    }
}

TEST(CameraModel, NoRayLiesBeyondAFold) {
    RandomNumbers random(13);
    int found = 0, wrong = 0;
    for (int round = 0; round < 1000; ++round) {
        const CameraModel camera = random.camera(1);
        const Intrinsics& i = camera.intrinsics;
        for (int sample = 0; sample < 50; ++sample) {
            const glm::dvec2 bent{random.between(-1.5, 1.5), random.between(-1.5, 1.5)};
            const auto ray = camera.unproject({bent.x * i.fx + i.cx, bent.y * i.fy + i.cy});
            if (!ray) continue;
            ++found;
            bool folds = false;
            for (int step = 1; step <= 100; ++step)
                folds |= determinantAt(camera.distortion, *ray * (step / 100.0)) < 0;
            wrong += folds;
        }
    }
    // A fold narrower than the sixteenth of the way between two looks may be missed.
    EXPECT_LE(500 * wrong, found) << wrong << " of " << found;
    EXPECT_GT(found, 20'000);
}

TEST(CameraModel, ResizedSeesTheSameRaysAtScaledPixels) {
    RandomNumbers random(3);
    const CameraModel camera = random.camera(0.5);
    const CameraModel half = camera.resized(400, 300);
    EXPECT_EQ(half.intrinsics.width, 400);
    EXPECT_EQ(half.intrinsics.height, 300);
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 point{random.between(-0.5, 0.5), random.between(-0.4, 0.4), 1};
        const glm::dvec2 full = *camera.project(point), small = *half.project(point);
        // Edges stay edges: -0.5 is the outer edge of pixel 0 at every size.
        EXPECT_NEAR((small.x + 0.5) / 400, (full.x + 0.5) / camera.intrinsics.width, 1e-12);
        EXPECT_NEAR((small.y + 0.5) / 300, (full.y + 0.5) / camera.intrinsics.height, 1e-12);
    }
    const Intrinsics binned = CameraModel{{640, 576, 500, 502, 319.5, 287.5}, {}}
                                  .resized(320, 288)
                                  .intrinsics; // a pixel of the binned picture is two by two
    EXPECT_DOUBLE_EQ(binned.fx, 250);
    EXPECT_DOUBLE_EQ(binned.fy, 251);
    EXPECT_DOUBLE_EQ(binned.cx, 159.5);
    EXPECT_DOUBLE_EQ(binned.cy, 143.5);
}

TEST(CameraModel, SaysWhatIsWrong) {
    struct Case {
        void (*spoil)(CameraModel&);
        const char* problem;
    };
    const Case cases[] = {
        {[](CameraModel& c) { c.intrinsics.width = 0; }, "width = 0 (allowed 1 to 16384)"},
        {[](CameraModel& c) { c.intrinsics.width = 16385; }, "width = 16385 (allowed 1 to 16384)"},
        {[](CameraModel& c) { c.intrinsics.height = -3; }, "height = -3 (allowed 1 to 16384)"},
        {[](CameraModel& c) { c.intrinsics.fx = 0; }, "fx = 0 (allowed a number > 0)"},
        {[](CameraModel& c) { c.intrinsics.fx = kNotANumber; }, "fx = nan (allowed a number > 0)"},
        {[](CameraModel& c) { c.intrinsics.fx = kInfinity; }, "fx = inf (allowed a number > 0)"},
        {[](CameraModel& c) { c.intrinsics.fy = -1; }, "fy = -1 (allowed a number > 0)"},
        {[](CameraModel& c) { c.intrinsics.fy = kNotANumber; }, "fy = nan (allowed a number > 0)"},
        {[](CameraModel& c) { c.intrinsics.cx = kNotANumber; }, "cx = nan (allowed a number)"},
        {[](CameraModel& c) { c.intrinsics.cy = -kInfinity; }, "cy = -inf (allowed a number)"},
        {[](CameraModel& c) { c.distortion.k1 = kNotANumber; },
         "distortion = nan (allowed finite numbers)"},
        {[](CameraModel& c) { c.distortion.p2 = kInfinity; },
         "distortion = inf (allowed finite numbers)"},
        {[](CameraModel& c) { c.distortion.k6 = kNotANumber; },
         "distortion = nan (allowed finite numbers)"},
        {[](CameraModel& c) { c.distortion.metricRadius = 0; }, "metric_radius = 0 (allowed > 0)"},
        {[](CameraModel& c) { c.distortion.metricRadius = kNotANumber; },
         "metric_radius = nan (allowed > 0)"},
    };
    EXPECT_FALSE(problemWith(plainCamera()));
    EXPECT_FALSE(problemWith(kinectColorCamera()));
    for (const Case& wrong : cases) {
        CameraModel camera = plainCamera();
        wrong.spoil(camera);
        EXPECT_EQ(problemWith(camera).value_or("nothing"), wrong.problem);
    }
}

} // namespace
} // namespace autostereo::calib

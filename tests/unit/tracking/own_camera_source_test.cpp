// Pictures handed over by a loop that must not wait for them to be looked at.

#include "devices/tracking/own_camera_source.hpp"
#include "tests/unit/tracking/head_video.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace autostereo::test {
namespace {

using namespace devices;

class OwnCamera : public testing::Test {
  protected:
    OwnCamera() {
        rig.color = rig.depth = webcam();
        params.spacingM = head.eyeSpacingM();
        const RgbPicture wall{640, 480, std::vector<std::uint8_t>(std::size_t{3} * 640 * 480, 120)};
        HeadView view;
        view.middle = {0.05, 0.02, 0.8};
        seen = head.draw(rig.color, wall, view);
    }
    RgbdFrame frame(TimePoint at) {
        FrameMetadata form;
        form.format = PixelFormat::Depth16;
        form.width = 640;
        form.height = 480;
        form.capturedAt = at;
        RgbdFrame pair;
        pair.depth = std::move(*pool.acquire(form));
        std::ranges::copy(seen.depthMm, pair.depth.depth().begin());
        pair.color = colorFrame(pool, seen.picture, at);
        return pair;
    }
    [[nodiscard]] double error(const EyeSample& sample) const {
        const glm::dvec3 truth = seen.eyes.middle();
        return glm::length(sample.eyes.middle() - glm::dvec3{-truth.x, -truth.y, truth.z});
    }
    RenderedHead head;
    HeadPicture seen;
    calib::SensorRig rig;
    ViewerParams params;
    FramePool pool{6};
};

TEST_F(OwnCamera, TheLoopDoesNotWait) {
    OwnCameraSource source(params, false);
    const TimePoint start = std::chrono::steady_clock::now();
    source.saw(frame(start)); // nobody has said of which cameras
    EXPECT_EQ(source.counters().received, 0U);
    source.useCameras(rig);
    int handed = 0;
    std::optional<EyeSample> sample;
    const auto end = start + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < end && (!sample || handed < 5)) {
        source.saw(frame(std::chrono::steady_clock::now()));
        ++handed;
        if (auto next = source.next(std::chrono::steady_clock::now())) sample = next;
    }
    ASSERT_TRUE(sample);
    EXPECT_LT(error(*sample), 0.02);
    const EyeCounters counted = source.counters();
    EXPECT_GE(counted.limited, 1U) << "a face takes longer to be found than a picture to be copied";
    EXPECT_LE(counted.received, static_cast<std::uint64_t>(handed));
    EXPECT_GE(counted.received + 2, static_cast<std::uint64_t>(handed)); // on their way
}

TEST_F(OwnCamera, HurriedPicturesAreAllLookedAtInLine) {
    OwnCameraSource source(params, true);
    source.useCameras(rig);
    for (int i = 0; i < 3; ++i)
        source.saw(frame(TimePoint{std::chrono::milliseconds(33 * i)}));
    EXPECT_EQ(source.counters().accepted, 3U);
    EXPECT_FALSE(source.next(TimePoint{} - std::chrono::milliseconds(1))) << "not taken yet";
    for (int i = 0; i < 3; ++i) {
        const auto sample = source.next(TimePoint{std::chrono::seconds(1)});
        ASSERT_TRUE(sample);
        EXPECT_EQ(sample->at, TimePoint{std::chrono::milliseconds(33 * i)});
        EXPECT_LT(error(*sample), 0.02);
    }
    EXPECT_FALSE(source.next(TimePoint{std::chrono::seconds(1)}));
}

} // namespace
} // namespace autostereo::test

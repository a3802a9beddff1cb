// What a camera that stands still has seen earlier is shown behind what stands in front now.

#include "devices/frame_pool.hpp"
#include "gpu/exports.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"

#include <cmath>

namespace autostereo::test {
namespace {

class BackgroundMemoryGlTest : public GlTest {
  protected:
    static constexpr int kWidth = 40, kHeight = 30;

    /// A frame of `count(x)` millimetres in front of a grey picture.
    template<class Count>
    void show(Count count) {
        frame.depth = *pool.acquire({devices::PixelFormat::Depth16, kWidth, kHeight});
        frame.color = *pool.acquire({devices::PixelFormat::Rgba8, 64, 48});
        for (int i = 0; i < kWidth * kHeight; ++i)
            frame.depth.depth()[static_cast<std::size_t>(i)] =
                static_cast<std::uint16_t>(count(i % kWidth));
        std::fill(frame.color.pixels().begin(), frame.color.pixels().end(), std::byte{90});
        if (!pipeline) {
            params.condition.hold = params.condition.flyingPixels = false;
            pipeline = std::make_unique<gpu::Pipeline>(
                params, devices::sim::simulatedRig(kWidth, kHeight, 64, 48), display, 96, 128);
        }
        pipeline->prepare(frame);
    }
    void showWall(int count, int frames) {
        for (int i = 0; i < frames; ++i)
            show([&](int) { return count; });
    }
    /// In the middle of the left and of the right half, metres.
    [[nodiscard]] std::array<double, 2> remembered() const {
        const gpu::gl::Texture& depth = pipeline->fusion().background().memory().depth();
        const auto width = static_cast<std::size_t>(depth.width());
        const auto height = static_cast<std::size_t>(depth.height());
        std::vector<float> texels(width * height);
        glGetTextureImage(depth.name(), 0, GL_RED, GL_FLOAT,
                          static_cast<GLsizei>(texels.size() * sizeof(float)), texels.data());
        const std::size_t row = height / 2 * width;
        return {static_cast<double>(texels[row + width / 4]),
                static_cast<double>(texels[row + 3 * width / 4])};
    }
    // The colour camera is tilted and stands beside: its depth of a wall differs a little.
    static void expectNear(const std::array<double, 2>& metres, double left, double right) {
        EXPECT_NEAR(metres[0], left, 0.06 * left);
        EXPECT_NEAR(metres[1], right, 0.06 * right);
    }

    gpu::PipelineParams params;
    calib::DisplayProfile display = smallLensDisplay(2, 1, 48, 64);
    devices::FramePool pool{4};
    devices::RgbdFrame frame;
    std::unique_ptr<gpu::Pipeline> pipeline;
};

TEST_F(BackgroundMemoryGlTest, KeepsTheFarthestThatWasSeenAndTrustsNoOutlier) {
    showWall(2000, 6);
    expectNear(remembered(), 2, 2);
    showWall(1000, 20);
    expectNear(remembered(), 2, 2);
    showWall(2000, 2);
    // An outlier on less of the picture than a moved camera would change.
    const auto outlier = [](int x) { return x >= 24 && x < 34 ? 4000 : 2000; };
    show(outlier);
    showWall(2000, 2);
    expectNear(remembered(), 2, 2);
    for (int i = 0; i < 6; ++i)
        show(outlier);
    expectNear(remembered(), 2, 4);
}

TEST_F(BackgroundMemoryGlTest, ForgetsAllWhenTheCameraIsMoved) {
    showWall(2000, 6);
    for (int i = 0; i < 3; ++i)
        show([](int x) { return x < kWidth / 2 ? 1000 : 3000; });
    expectNear(remembered(), 1, 3);
}

struct Quality {
    double seenDb = 0, hiddenDb = 0;
    std::size_t hidden = 0;
};

/// A picture of the person, taken from `offset`, against rays cast from there.
Quality judge(const gpu::RgbImage& image, const calib::SensorRig& rig, glm::dvec3 offset,
              double seconds) {
    const auto scene = devices::sim::makeScene("person", 1);
    const auto room = devices::sim::makeScene("room", 1);
    const auto snapshot = scene->at(seconds), before = room->at(seconds);
    const auto sees = [](const devices::sim::Snapshot& at, const devices::sim::Hit& hit) {
        return at.trace({{0, 0, 0}, hit.point}).distance > 0.98;
    };
    std::array<double, 2> sum{};
    std::array<std::size_t, 2> pixels{};
    for (int y = 20; y < image.height - 20; y += 2)
        for (int x = 60; x < image.width - 60; x += 2) {
            const auto ray = rig.color.unproject({x, y});
            const auto hit = snapshot.trace({offset, glm::dvec3(*ray, 1)});
            if (!sees(before, hit) && !sees(snapshot, hit)) continue; // furniture hides it
            const std::size_t kind = sees(snapshot, hit) ? 0 : 1;
            for (int c = 0; c < 3; ++c) {
                const auto at =
                    3 * static_cast<std::size_t>(y * image.width + x) + static_cast<std::size_t>(c);
                const double off = image.pixels[at] - hit.color[c];
                sum[kind] += off * off;
                ++pixels[kind];
            }
        }
    const auto db = [&](std::size_t kind) {
        return 10 * std::log10(255.0 * 255.0 * static_cast<double>(pixels[kind]) / sum[kind]);
    };
    return {db(0), db(1), pixels[1] / 3};
}

/// The room without anybody first, then the person: from 10 cm to the right, what he hides.
TEST_F(BackgroundMemoryGlTest, WhatAVisitorHidesIsNearlyAsGoodAsWhatIsSeen) {
    if (IsSkipped()) return;
    constexpr glm::dvec3 kOffset{0.1, 0, 0};
    const std::string form = "?depth=320x288&color=640x360&noise=off";
    std::array<Quality, 2> found;
    for (const int roomFrames : {0, 6}) {
        const CapturedPair room = simulate("sim:room" + form),
                           person = simulate("sim:person" + form);
        gpu::Pipeline gpuStages({}, person.rig, display, 96, 128);
        gpu::MovedCamera camera({}, person.rig, kOffset);
        for (int i = 0; i < roomFrames; ++i) {
            gpuStages.prepare(room.frame);
            static_cast<void>(camera.render(gpuStages));
        }
        gpuStages.prepare(person.frame);
        found[roomFrames > 0 ? 1 : 0] = judge(camera.render(gpuStages), person.rig, kOffset, 0.004);
    }
    std::printf("never seen: %.2f dB, seen %.2f; remembered: %.2f, %.2f (%zu pixels hidden)\n",
                found[0].hiddenDb, found[0].seenDb, found[1].hiddenDb, found[1].seenDb,
                found[1].hidden);
    ASSERT_GT(found[1].hidden, 1000U);
    EXPECT_GE(found[1].hiddenDb, found[1].seenDb - 3);
    EXPECT_GE(found[1].hiddenDb, found[0].hiddenDb + 1);
}

} // namespace
} // namespace autostereo::test

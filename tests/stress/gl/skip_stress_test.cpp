// Doing again only what a frame changes fills the panel with the bytes that doing everything does:
// whole pipelines, in which things of any size come, move and go, in depth, in colour and in both,
// with noise and without, and the scene is put elsewhere.

#include "devices/frame_pool.hpp"
#include "tests/stress/campaign.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"

#include <algorithm>
#include <cstdio>
#include <random>

namespace autostereo::test {
namespace {

constexpr int kWidth = 48, kHeight = 36, kColorWidth = 80, kColorHeight = 60;
constexpr int kPanelWidth = 192, kPanelHeight = 128;

/// Pairs of frames in which rectangles are overwritten, now and then with noise all over.
class MovingPictures {
  public:
    MovingPictures()
        : depth_(kWidth * kHeight, 2000), color_(kColorWidth * kColorHeight, 0x406080) {}

    devices::RgbdFrame next() {
        for (int i = integer(0, 3); i > 0; --i)
            integer(0, 2) == 0 ? moveColor() : moveDepth();
        if (integer(0, 60) == 0) std::ranges::fill(depth_, anyCount()); // the camera was moved
        devices::RgbdFrame frame;
        frame.depth = *pool_.acquire({devices::PixelFormat::Depth16, kWidth, kHeight});
        frame.color = *pool_.acquire({devices::PixelFormat::Rgba8, kColorWidth, kColorHeight});
        fillDepth(frame.depth);
        fillColor(frame.color);
        return frame;
    }

  private:
    struct Place {
        int x, y, width, height;
    };
    int integer(int least, int most) { return std::uniform_int_distribution(least, most)(random_); }
    std::uint16_t anyCount() { return static_cast<std::uint16_t>(integer(500, 4000)); }
    Place place(int columns, int rows) {
        const int width = integer(1, integer(1, columns)), height = integer(1, integer(1, rows));
        return {integer(0, columns - width), integer(0, rows - height), width, height};
    }
    template<class Texel, class Value>
    void fill(std::vector<Texel>& texels, int columns, const Place& at, Value value) {
        for (int y = at.y; y < at.y + at.height; ++y)
            for (int x = at.x; x < at.x + at.width; ++x)
                texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                       static_cast<std::size_t>(x)] = value(x);
    }
    /// A surface that faces the camera or is slanted, or nothing.
    void moveDepth() {
        const int count = integer(0, 9) == 0 ? 0 : anyCount(),
                  slant = count > 0 ? integer(-8, 8) : 0;
        fill(depth_, kWidth, place(kWidth, kHeight),
             [&](int x) { return static_cast<std::uint16_t>(std::max(count + slant * x, 0)); });
    }
    void moveColor() {
        const auto color = static_cast<std::uint32_t>(random_());
        fill(color_, kColorWidth, place(kColorWidth, kColorHeight), [&](int) { return color; });
    }
    void fillDepth(devices::Frame& frame) {
        const int noise = integer(0, 3) == 0 ? 2 * integer(1, 2) : 0;
        std::ranges::transform(depth_, frame.depth().begin(), [&](int count) {
            return static_cast<std::uint16_t>(count == 0 ? 0 : count + integer(-noise, noise));
        });
    }
    void fillColor(devices::Frame& frame) {
        const int noise = integer(0, 3) == 0 ? integer(1, 2) : 0;
        auto* bytes = reinterpret_cast<std::uint8_t*>(frame.pixels().data());
        for (std::size_t i = 0; i < 4 * color_.size(); ++i) {
            const int value = static_cast<int>(color_[i / 4] >> (8 * (i % 4)) & 0xffU);
            bytes[i] = static_cast<std::uint8_t>(
                i % 4 == 3 ? 255 : std::clamp(value + integer(-noise, noise), 0, 255));
        }
    }

    std::mt19937 random_{23};
    devices::FramePool pool_{4};
    std::vector<std::uint16_t> depth_;
    std::vector<std::uint32_t> color_;
};

/// A pipeline and its panel.
struct Shown {
    Shown(gpu::PipelineParams params, bool skips, const calib::DisplayProfile& display)
        : target(GL_RGBA8, kPanelWidth, kPanelHeight), panel(gpu::gl::makeFramebuffer(target)),
          pipeline((params.skipUnchanged = skips, params),
                   devices::sim::simulatedRig(kWidth, kHeight, kColorWidth, kColorHeight), display,
                   kPanelWidth, kPanelHeight) {}

    std::vector<std::uint8_t> show(const devices::RgbdFrame& frame) {
        pipeline.render(frame, panel.name());
        return gpu::readFramebuffer(panel.name(), kPanelWidth, kPanelHeight).pixels;
    }

    gpu::gl::Texture target;
    gpu::gl::Framebuffer panel;
    gpu::Pipeline pipeline;
};

class SkipStressTest : public GlTest {
  protected:
    static calib::DisplayProfile lensDisplay() {
        calib::DisplayProfile display = smallLensDisplay(8, 1, 64, 64);
        display.disparityNear = 0.15; // a ray passes many texels
        display.disparityFar = -0.15;
        return display;
    }
    static void compare(const gpu::PipelineParams& params, std::uint64_t motions) {
        const calib::DisplayProfile display = lensDisplay();
        MovingPictures pictures;
        Shown skipping(params, true, display), everything(params, false, display);
        for (std::uint64_t i = 0; i < motions; ++i) {
            if (i % 97 == 96) { // the scene is put elsewhere
                gpu::DepthBudgetParams budget;
                budget.focusM = 1 + static_cast<double>(i % 5) / 4;
                for (Shown* shown : {&skipping, &everything})
                    shown->pipeline.adjust(budget, gpu::Method::Direct);
            }
            const devices::RgbdFrame frame = pictures.next();
            ASSERT_EQ(skipping.show(frame), everything.show(frame)) << "motion " << i;
        }
        const auto kept = skipping.pipeline.keptShare().value_or(gpu::KeptShare{});
        EXPECT_GT(kept.search, 0.05) << "or nothing was tested";
        const double fusion = skipping.pipeline.fusion().holes().keptShare().value_or(0);
        EXPECT_GT(fusion, 0.1) << "or nothing was tested";
        EXPECT_EQ(everything.pipeline.keptShare().value_or(gpu::KeptShare{1, 1}).picture, 0.0);
        std::printf("%llu motions, not done: %.0f %% of fusion, %.0f %% of the search, "
                    "%.0f %% of the colours\n",
                    static_cast<unsigned long long>(motions), 100 * fusion, 100 * kept.search,
                    100 * kept.picture);
    }
};

TEST_F(SkipStressTest, NoByteDiffersFromDoingEverything) {
    if (IsSkipped()) return;
    gpu::PipelineParams params;
    params.color.sigma = 1;
    compare(params, campaign(500, 10'000));
}

TEST_F(SkipStressTest, NorWithoutHoldingAnything) {
    if (IsSkipped()) return;
    gpu::PipelineParams params;
    params.condition.hold = params.condition.flyingPixels = false;
    params.fusion.remember = false;
    params.backdrop.cutM = 3;
    compare(params, campaign(100, 2'000));
}

} // namespace
} // namespace autostereo::test

// Disparity as a picture of its own, and as the grey half of a 2D-plus-depth frame: the registered
// depth through the display's law.

#include "config/load.hpp"
#include "daemon/commands/plain_display.hpp"
#include "gpu/scene_geometry.hpp"
#include "tests/replay/pictures.hpp"
#include "tests/replay/program.hpp"
#include "tests/support/tiff_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace autostereo::test {
namespace {

constexpr int kSide = 96;

int depthOf(int x, int y) { return x >= 20 && x < 44 && y >= 30 && y < 60 ? 1300 : 1700; }

class DisparityReplay : public testing::Test {
  protected:
    std::string render(const std::string& as, const std::string& output) {
        const std::string color = writeColor(folder / "c.png", kSide, kSide, [](int x, int y) {
            return Rgb{static_cast<std::uint8_t>(2 * x), static_cast<std::uint8_t>(2 * y), 9};
        });
        const std::string input = "rgbd:" + color + "," +
                                  writeDepth(folder / "d.png", kSide, kSide, depthOf) + "," +
                                  cameraFile(folder, kSide, kSide);
        EXPECT_TRUE(succeeded(runProgram(
            calling({"render", "--input", input, "--display", smallDisplay(folder), "--config",
                     folder.file("config.toml", "[depth]\nfocus_m = 1.5\nscale = 0.8\n"), "--as",
                     as, "--output", folder / output}))));
        return folder / output;
    }
    /// The law and the framing of what was rendered.
    [[nodiscard]] gpu::SceneGeometry geometry(const calib::DisplayProfile& display) const {
        constexpr double kMiddle = (kSide - 1) / 2.0;
        calib::SensorRig rig;
        rig.depth = rig.color = {{kSide, kSide, kSide, kSide, kMiddle, kMiddle}, {}};
        gpu::PipelineParams params;
        params.budget.depthScale = 0.8;
        return gpu::sceneGeometry(rig, display, params,
                                  static_cast<double>(kSmallWidth) / kSmallHeight, 1.5);
    }
    /// Millimetres that the registered depth has where the panel shows (u, v up).
    static int depthAt(const DepthPicture& depth, const gpu::SceneGeometry& geometry, double u,
                       double v) {
        const glm::dvec2 ray = geometry.framing.rayFromPanel({u, v});
        return depth.at(static_cast<int>(std::lround(ray.x * kSide + (kSide - 1) / 2.0)),
                        static_cast<int>(std::lround(ray.y * kSide + (kSide - 1) / 2.0)));
    }
    TempFolder folder;
};

TEST_F(DisparityReplay, IsTheRegisteredDepthThroughTheDisplaysLaw) {
    const FloatTiff tiff = readFloatTiff(render("disparity", "d.tif"));
    const DepthPicture depth = readDepth(render("depth", "z.png"));
    ASSERT_EQ(tiff.width, kSmallWidth);
    ASSERT_EQ(tiff.height, kSmallHeight);
    const auto display = config::loadDisplay(smallDisplay(folder));
    const gpu::SceneGeometry shown = geometry(display);
    int off = 0, near = 0, far = 0;
    for (int y = 0; y < kSmallHeight; ++y)
        for (int x = 0; x < kSmallWidth; ++x) {
            const int z =
                depthAt(depth, shown, (x + 0.5) / kSmallWidth, 1 - (y + 0.5) / kSmallHeight);
            const double d = tiff.at(x, y);
            off += std::abs(d - shown.law.disparity(z * 1e-3)) > 1e-5 ? 1 : 0;
            near += d > 0 ? 1 : 0;
            far += d < 0 ? 1 : 0;
        }
    EXPECT_GT(near, 2000);
    EXPECT_GT(far, 2000);
    EXPECT_LE(off, (near + far) / 50) << "only at edges another pixel decides";
}

TEST_F(DisparityReplay, IsTheGreyHalfOfADepthFrame) {
    const ColorPicture frame = readColor(render("2d-plus-depth", "frame.png"));
    const DepthPicture depth = readDepth(render("depth", "z.png"));
    const auto display = config::loadDisplay(smallDisplay(folder));
    const gpu::SceneGeometry shown = geometry(display);
    const auto law = std::get<calib::DepthFrame>(
        daemon::plainDisplay(display, daemon::PlainFormat::DepthFrame, kSmallWidth, kSmallHeight)
            .law);
    int off = 0;
    const int half = kSmallWidth / 2;
    for (int y = 1; y < kSmallHeight; ++y)
        for (int x = 0; x < half; ++x) {
            const int z = depthAt(depth, shown, (x + 0.5) / half, 1 - (y + 0.5) / kSmallHeight);
            const double grey = law.screenLevel + law.gain * shown.law.disparity(z * 1e-3);
            off += std::abs(frame.at(half + x, y)[0] - grey) > 0.51 ? 1 : 0;
        }
    EXPECT_LE(off, half * kSmallHeight / 50);
    EXPECT_LT(frame.at(kSmallWidth - 4, 90)[0], 128) << "the wall lies behind the panel";
}

} // namespace
} // namespace autostereo::test

// A viewer whose face a camera sees, on a tracked barrier, through the program alone.

#include "tests/replay/kiosk.hpp"
#include "tests/replay/tracked_panel.hpp"
#include "tests/support/rendered_head.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>

namespace autostereo::test {
namespace {

constexpr int kWidth = 640, kHeight = 480;
/// Above the panel, which a camera of 53 degrees looks out of.
constexpr const char* kAbove = "[viewer]\nsource = \"%s\"\norigin_mm = [0, 130, 0]\n"
                               "eye_spacing_mm = 62.95\ndelay_ms = 0\nease_ms = %d\n";

std::string viewerConfig(const std::string& source, int easeMs) {
    std::array<char, 512> text{};
    std::snprintf(text.data(), text.size(), kAbove, source.c_str(), easeMs);
    return text.data();
}

std::size_t indexOf(int x, int y) {
    return static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
}

/// Pictures of somebody who stands still, and where their eyes are in display space.
class Footage {
  public:
    explicit Footage(const std::filesystem::path& folder) : folder_(folder) {
        std::filesystem::create_directory(folder_);
        camera_.intrinsics = {
            kWidth, kHeight, kWidth, kWidth, (kWidth - 1) / 2.0, (kHeight - 1) / 2.0};
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) // a wall with stripes
                for (int c = 0; c < 3; ++c)
                    wall_.rgb.push_back(static_cast<std::uint8_t>(90 + 50 * (x / 40 % 2) + 10 * c));
        HeadView view;
        view.middle = {0.08, 0.11, 0.62};
        view.yaw = 0.05;
        seen_ = head_.draw(camera_, wall_, view);
    }
    void addViewer(int pictures) { add(seen_.picture, pictures, true); }
    void addNobody(int pictures) { add(wall_, pictures, false); }
    [[nodiscard]] glm::dvec3 eye(const glm::dvec3& at) const { return {-at.x, 0.13 - at.y, at.z}; }
    [[nodiscard]] glm::dvec3 left() const { return eye(seen_.eyes.left); }
    [[nodiscard]] glm::dvec3 right() const { return eye(seen_.eyes.right); }

  private:
    void add(const RgbPicture& picture, int pictures, bool withDepth) {
        const auto color = [&](int x, int y) {
            const std::uint8_t* pixel = &picture.rgb[3 * indexOf(x, y)];
            return Rgb{pixel[0], pixel[1], pixel[2]};
        };
        const auto depth = [&](int x, int y) {
            return withDepth ? seen_.depthMm[indexOf(x, y)] : 2500;
        };
        const int first = next_;
        for (; next_ < first + pictures; ++next_) {
            const auto name = [&](int number, const char* what) {
                return folder_ / ("frame-" + std::to_string(number) + what);
            };
            if (next_ == first) {
                writeColor(name(first, ".color.png"), kWidth, kHeight, color);
                writeDepth(name(first, ".depth.png"), kWidth, kHeight, depth);
                continue;
            }
            for (const char* what : {".color.png", ".depth.png"})
                std::filesystem::create_hard_link(name(first, what), name(next_, what));
        }
    }
    std::filesystem::path folder_;
    calib::CameraModel camera_;
    RenderedHead head_;
    RgbPicture wall_{kWidth, kHeight, {}};
    HeadPicture seen_;
    int next_ = 0;
};

std::string text(const glm::dvec3& eye) {
    return std::to_string(eye.x) + "," + std::to_string(eye.y) + "," + std::to_string(eye.z);
}

/// Both true eyes see their own view, as a recorded viewer's do (viewer_test).
void expectSeparated(const TrackedPanel& panel, const Footage& footage) {
    const std::string leftEye = text(footage.left()), rightEye = text(footage.right());
    const ColorPicture left = panel.seen(leftEye), right = panel.seen(rightEye);
    const ColorPicture leftView = panel.view(leftEye), rightView = panel.view(rightEye);
    std::printf("left eye %.1f dB (%.1f of the other's view), right %.1f dB (%.1f)\n",
                psnr(left, leftView), psnr(left, rightView), psnr(right, rightView),
                psnr(right, leftView));
    EXPECT_GT(psnr(left, leftView), psnr(left, rightView) + 3);
    EXPECT_GT(psnr(right, rightView), psnr(right, leftView) + 3);
}

TEST(SeenViewer, EachEyeSeesItsOwnViewOfAPictureThatTheViewerIsIn) {
    TrackedPanel panel;
    Footage footage(panel.folder() / "own");
    footage.addViewer(8);
    const std::string input = "seq:" + (panel.folder() / "own");
    const std::string rig = cameraFile(panel.folder(), kWidth, kHeight);
    std::filesystem::copy(rig, std::filesystem::path(panel.folder() / "own") / "camera.json");
    panel.run(input, viewerConfig("camera:", 0), {"--speed", "max"});
    expectSeparated(panel, footage);
}

TEST(SeenViewer, EachEyeSeesItsOwnViewByACameraOfItsOwn) {
    TrackedPanel panel;
    Footage footage(panel.folder() / "webcam");
    footage.addViewer(8);
    const std::string source = "camera:seq:" + (panel.folder() / "webcam");
    panel.run(std::string(kSmallRoom) + "&noise=off",
              viewerConfig(source, 0) + "lost_after_ms = 2000\ncamera_fov_deg = 53.13\n",
              {"--frames", "60"});
    expectSeparated(panel, footage);
}

TEST(SeenViewer, IsLostAndFoundAgain) {
    const TempFolder folder;
    Footage footage(folder / "webcam");
    footage.addViewer(24);
    footage.addNobody(36);
    Kiosk kiosk(viewerConfig("camera:seq:" + (folder / "webcam") + "?fps=12", 500) +
                    "camera_fov_deg = 53.13\n",
                kBarrier);
    kiosk.plugBoth();
    kiosk.start();
    ASSERT_TRUE(kiosk.shows("live", std::chrono::seconds(10)));
    const glm::dvec3 nominal{0, 0, 0.65};
    const glm::dvec3 place = (footage.left() + footage.right()) / 2.0;
    const auto stands = [&](bool tracked, const glm::dvec3& where) {
        const auto viewer = kiosk.status().at("viewer");
        const auto& eyes = viewer.at("eyes_m");
        glm::dvec3 middle{0};
        for (int axis = 0; axis < 3; ++axis)
            middle[axis] = (eyes.at(0).at(static_cast<std::size_t>(axis)).get<double>() +
                            eyes.at(1).at(static_cast<std::size_t>(axis)).get<double>()) /
                           2;
        return viewer.at("tracked").get<bool>() == tracked && glm::length(middle - where) < 0.015;
    };
    for (int round = 0; round < 2; ++round) {
        EXPECT_TRUE(
            eventually([&] { return stands(true, place); }, std::chrono::seconds(15 * kSlower)))
            << kiosk.status().at("viewer").dump();
        EXPECT_TRUE(
            eventually([&] { return stands(false, nominal); }, std::chrono::seconds(15 * kSlower)))
            << kiosk.status().at("viewer").dump();
    }
    const auto samples = kiosk.status().at("viewer").at("samples");
    EXPECT_GT(samples.at("accepted").get<int>(), 10);
    EXPECT_GT(samples.at("nobody").get<int>(), 5);
    std::printf("%s\n", samples.dump().c_str());
    EXPECT_TRUE(succeeded(kiosk.stop()));
}

TEST(SeenViewer, WhatIsNoCameraIsRefusedInALine) {
    TrackedPanel panel;
    for (const char* source : {"camera:v4l2:/dev/none", "camera:seq:/nowhere", "camera:nothing:"}) {
        const auto result = runProgram(
            calling({"run", "--config", panel.folder().file("viewer.toml", viewerConfig(source, 0)),
                     "--input", kSmallRoom, "--display", panel.display(), "--output", "offscreen",
                     "--frames", "2"}));
        EXPECT_TRUE(failedPlainly(result)) << source;
    }
}

} // namespace
} // namespace autostereo::test

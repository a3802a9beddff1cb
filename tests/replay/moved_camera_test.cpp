// render --camera-offset against real pictures of the same scene from beside: Middlebury's stereo
// sets, left picture and left disparity in, right picture out.

#include "tests/replay/middlebury.hpp"
#include "tests/replay/program.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>

namespace autostereo::test {
namespace {

constexpr double kBaselineM = 0.1;

double luma(const std::uint8_t* rgb) { return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2]; }

/// Luma PSNR over kinds of the right picture's pixels.
struct Quality {
    double seen, disoccluded, outOfFrame, hidden, all;
};

Quality judge(const ColorPicture& picture, const StereoTruth& truth) {
    std::array<double, 3> sum{};
    std::array<std::size_t, 3> pixels{};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double off = luma(picture.at(x, y)) - luma(truth.right.at(x, y));
            const std::size_t kind = truth.seen(x, y) ? 0 : truth.disoccluded(x, y) ? 1 : 2;
            sum[kind] += off * off;
            ++pixels[kind];
        }
    const auto db = [](double squares, std::size_t count) {
        return 10 * std::log10(255.0 * 255.0 * static_cast<double>(count) / squares);
    };
    return {db(sum[0], pixels[0]), db(sum[1], pixels[1]), db(sum[2], pixels[2]),
            db(sum[1] + sum[2], pixels[1] + pixels[2]),
            db(sum[0] + sum[1] + sum[2], pixels[0] + pixels[1] + pixels[2])};
}

void print(const char* what, const Quality& found) {
    std::printf(
        "  %-14s seen %.2f dB, all %.2f; hidden %.2f: disoccluded %.2f, out of frame %.2f\n", what,
        found.seen, found.all, found.hidden, found.disoccluded, found.outOfFrame);
}

std::size_t blackPixels(const ColorPicture& picture) {
    std::size_t black = 0;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
        black += picture.rgb[i] + picture.rgb[i + 1] + picture.rgb[i + 2] == 0 ? 1U : 0U;
    return black;
}

class MovedCamera : public testing::TestWithParam<StereoPair> {
  protected:
    /// Depth = width * baseline / disparity, in steps that use the 16 bits.
    [[nodiscard]] ColorPicture render(const StereoTruth& truth) const {
        const ColorPicture& left = truth.left;
        double least = 1e9;
        for (const auto& row : truth.disparity)
            least = std::min(least, *std::min_element(row.begin(), row.end()));
        const double unit = left.width * kBaselineM / least / 65000;
        const std::string depth =
            writeDepth(folder / "depth.png", left.width, left.height, [&](int x, int y) {
                const double d =
                    truth.disparity[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
                return static_cast<int>(std::lround(left.width * kBaselineM / d / unit));
            });
        const std::string color =
            writeColor(folder / "color.png", left.width, left.height, [&](int x, int y) {
                const auto* rgb = left.at(x, y);
                return Rgb{rgb[0], rgb[1], rgb[2]};
            });
        writeCamera(left.width, left.height, unit);
        EXPECT_TRUE(succeeded(runProgram(calling(
            {"render", "--input", "rgbd:" + color + "," + depth + "," + (folder / "camera.json"),
             "--display", "preview", "--as", "view", "--camera-offset",
             std::to_string(GetParam().baselines * kBaselineM) + ",0,0", "--output",
             folder / "moved.png"}))));
        return readColor(folder / "moved.png");
    }

    void writeCamera(int width, int height, double unit) const {
        const auto number = [](double value) { return std::to_string(value); };
        const std::string camera =
            "\"width\": " + number(width) + ", \"height\": " + number(height) +
            ", \"fx\": " + number(width) + ", \"fy\": " + number(width) +
            ", \"cx\": " + number((width - 1) / 2.0) + ", \"cy\": " + number((height - 1) / 2.0) +
            ", \"distortion_k1k2p1p2k3k4k5k6\": [0,0,0,0,0,0,0,0]";
        std::ofstream(folder / "camera.json")
            << "{\"depth\": {" << camera << ", \"depth_scale_m\": " << unit
            << ", \"invalid\": 0}, \"color\": {" << camera
            << "}, \"depth_to_color\": {\"R_rowmajor\": [1,0,0,0,1,0,0,0,1], \"t_m\": [0,0,0]}}";
    }

    TempFolder folder;
};

TEST_P(MovedCamera, SeesWhatTheOtherCameraSaw) {
    const StereoPair& pair = GetParam();
    AUTOSTEREO_NEED_DATA(std::filesystem::path("middlebury") / pair.folder);
    const StereoTruth truth(pair, dataDir() / "middlebury" / pair.folder);
    const ColorPicture picture = render(truth);
    const Quality ours = judge(picture, truth);
    const Quality telea = judge(plainWarp(truth, pair.baselines, HoleFilling::Telea), truth);
    const Quality rows =
        judge(plainWarp(truth, pair.baselines, HoleFilling::RowsFartherEnd), truth);
    std::printf("%s\n", pair.name);
    print("ours", ours);
    print("warp and Telea", telea);
    print("warp and rows", rows);
    EXPECT_GE(ours.seen, pair.leastSeenDb);
    EXPECT_GE(ours.all, pair.leastAllDb);
    if (pair.leastGainDb >= 0) {
        EXPECT_GE(ours.all, telea.all + pair.leastGainDb);
    }
    if (pair.leastRowDb >= 0) {
        EXPECT_GE(ours.hidden, rows.hidden + pair.leastRowDb);
    }
    EXPECT_LE(blackPixels(picture), 2 * blackPixels(truth.left) + 10)
        << "pixels that show nothing are black";
}

constexpr StereoPair newer(const char* name) {
    return {name, name, "view1.png", "view5.png", "disp1.png", "disp5.png", 3};
}
constexpr StereoPair tsukuba(const char* name, const char* view, double baselines) {
    return {name, "tsukuba", "img_left.png", view, "disp_gt.pgm", nullptr, 16, baselines, 18};
}

INSTANTIATE_TEST_SUITE_P(Middlebury, MovedCamera,
                         testing::Values(StereoPair{"cones", "cones", "im2.png", "im6.png",
                                                    "disp2.png", "disp6.png", 4, 1, 0, 30.3, 24.6,
                                                    0.5, 1},
                                         newer("art"), newer("books"), newer("dolls"),
                                         StereoPair{"aloe", "aloe", "aloeL.jpg", "aloeR.jpg",
                                                    "aloeGT.png", nullptr, 1, 1, 0, 0, 0, 0.5},
                                         tsukuba("tsukuba_plus_1", "img_right.png", 1),
                                         tsukuba("tsukuba_plus_2", "col5.png", 2),
                                         tsukuba("tsukuba_minus_2", "col1.png", -2)),
                         [](const auto& pair) { return pair.param.name; });

} // namespace
} // namespace autostereo::test

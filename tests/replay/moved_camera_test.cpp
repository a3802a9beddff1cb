// render --camera-offset against real pictures of the same scene from beside: Middlebury's stereo
// sets, left picture and left disparity in, right picture out.

#include "devices/replay/image_files.hpp"
#include "tests/replay/pictures.hpp"
#include "tests/replay/program.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>
#include <opencv2/photo.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

namespace autostereo::test {
namespace {

constexpr double kBaselineM = 0.1;

struct Scene {
    const char* name;
    const char *left, *right, *leftDisparity, *rightDisparity;
    int greyPerPixel;
    double leastSeenDb, leastAllDb; ///< 0: stated only
    double leastGainDb;             ///< against a plain warp; -1: stated only
};

void PrintTo(const Scene& scene, std::ostream* out) { // NOLINT(readability-identifier-naming)
    *out << scene.name;
}

/// Rows of one number a pixel.
using Plane = std::vector<std::vector<double>>;

/// Any PNG or JPEG as RGB.
ColorPicture readAny(const std::filesystem::path& file) {
    devices::ImageReader reader;
    const devices::ImageHeader header = reader.open(file);
    std::vector<std::byte> pixels(header.bytes());
    reader.decode(pixels);
    ColorPicture picture{header.width, header.height, {}};
    for (std::size_t i = 0; i < pixels.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c)
            picture.rgb.push_back(static_cast<std::uint8_t>(pixels[i + c]));
    return picture;
}

Plane disparityOf(const std::filesystem::path& file, int greyPerPixel) {
    const ColorPicture grey = readAny(file);
    Plane plane;
    for (int y = 0; y < grey.height; ++y) {
        plane.emplace_back();
        for (int x = 0; x < grey.width; ++x)
            plane.back().push_back(grey.at(x, y)[0] / static_cast<double>(greyPerPixel));
    }
    return plane;
}

/// Unknown pixels take the farther of their row's neighbours.
Plane withoutHoles(Plane plane) {
    for (auto& row : plane) {
        const std::vector<double> known = row;
        const auto nearest = [&](int from, int step) {
            for (int x = from; x >= 0 && x < static_cast<int>(known.size()); x += step)
                if (known[static_cast<std::size_t>(x)] > 0)
                    return known[static_cast<std::size_t>(x)];
            return 1e9;
        };
        for (std::size_t x = 0; x < row.size(); ++x)
            if (row[x] == 0)
                row[x] =
                    std::min(nearest(static_cast<int>(x), -1), nearest(static_cast<int>(x), 1));
    }
    return plane;
}

double luma(const std::uint8_t* rgb) { return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2]; }

/// Luma PSNR over the pixels that `counts(x, y)` names.
template<class Counts>
double psnr(const ColorPicture& a, const ColorPicture& b, Counts counts) {
    double sum = 0;
    std::size_t pixels = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            if (!counts(x, y)) continue;
            const double off = luma(a.at(x, y)) - luma(b.at(x, y));
            sum += off * off;
            ++pixels;
        }
    return 10 * std::log10(255.0 * 255.0 * static_cast<double>(pixels) / sum);
}

/// Bicubic (Keys, a = -1/2) between the pixels of a row.
std::array<double, 3> cubic(const ColorPicture& picture, double x, int y) {
    const auto weight = [](double t) {
        t = std::abs(t);
        if (t < 1) return (1.5 * t - 2.5) * t * t + 1;
        return t < 2 ? ((-0.5 * t + 2.5) * t - 4) * t + 2 : 0.0;
    };
    const int left = static_cast<int>(std::floor(x));
    std::array<double, 3> color{};
    for (int i = left - 1; i <= left + 2; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            color[c] += weight(x - i) * picture.at(std::clamp(i, 0, picture.width - 1), y)[c];
    return color;
}

/// The plain way: each pixel moves by its disparity, surfaces are torn where neighbours part by
/// more than a pixel, holes are filled by OpenCV (Telea 2004).
ColorPicture warpedAndInpainted(const ColorPicture& left, const Plane& disparity) {
    ColorPicture warped = left;
    cv::Mat picture(left.height, left.width, CV_8UC3, warped.rgb.data());
    cv::Mat holes(left.height, left.width, CV_8UC1, cv::Scalar(1)), result;
    for (int y = 0; y < left.height; ++y) {
        const auto& row = disparity[static_cast<std::size_t>(y)];
        std::vector<double> nearest(row.size(), -1);
        for (std::size_t u = 0; u + 1 < row.size(); ++u) {
            const double a = static_cast<double>(u) - row[u];
            const double b = static_cast<double>(u + 1) - row[u + 1];
            if (std::abs(row[u] - row[u + 1]) > 1 || b <= a) continue;
            for (int x = std::max(0, static_cast<int>(std::ceil(a)));
                 x <= std::min(left.width - 1.0, std::floor(b)); ++x) {
                const double t = (x - a) / (b - a), d = row[u] + t * (row[u + 1] - row[u]);
                if (d <= nearest[static_cast<std::size_t>(x)]) continue;
                nearest[static_cast<std::size_t>(x)] = d;
                holes.at<std::uint8_t>(y, x) = 0;
                const auto color = cubic(left, static_cast<double>(u) + t, y);
                for (int c = 0; c < 3; ++c)
                    picture.at<cv::Vec3b>(y, x)[c] =
                        cv::saturate_cast<std::uint8_t>(color[static_cast<std::size_t>(c)]);
            }
        }
    }
    cv::inpaint(picture, holes, result, 3, cv::INPAINT_TELEA);
    return {left.width, left.height, {result.datastart, result.dataend}};
}

class MovedCamera : public testing::TestWithParam<Scene> {
  protected:
    [[nodiscard]] std::filesystem::path file(const char* name) const {
        return dataDir() / "middlebury" / GetParam().name / name;
    }

    /// Depth = width * baseline / disparity, in steps that use the 16 bits.
    [[nodiscard]] ColorPicture render(const ColorPicture& left, const Plane& disparity,
                                      double offsetM) const {
        double least = 1e9;
        for (const auto& row : disparity)
            least = std::min(least, *std::min_element(row.begin(), row.end()));
        const double unit = left.width * kBaselineM / least / 65000;
        const std::string depth =
            writeDepth(folder / "depth.png", left.width, left.height, [&](int x, int y) {
                const double d =
                    disparity[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
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
             std::to_string(offsetM) + ",0,0", "--output", folder / "moved.png"}))));
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
    const Scene& scene = GetParam();
    AUTOSTEREO_NEED_DATA(std::filesystem::path("middlebury") / scene.name);
    const ColorPicture left = readAny(file(scene.left)), right = readAny(file(scene.right));
    const Plane known = disparityOf(file(scene.leftDisparity), scene.greyPerPixel);
    const Plane disparity = withoutHoles(known);
    Plane other;
    if (scene.rightDisparity != nullptr)
        other = disparityOf(file(scene.rightDisparity), scene.greyPerPixel);
    const auto seen = [&](int x, int y) {
        if (other.empty()) return true;
        const double d = other[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
        const auto u = static_cast<std::size_t>(std::lround(x + d));
        const auto& row = known[static_cast<std::size_t>(y)];
        return d > 0 && u < row.size() && row[u] > 0 && std::abs(row[u] - d) <= 1;
    };
    const auto hidden = [&](int x, int y) { return !seen(x, y); };
    const auto all = [](int, int) { return true; };

    const ColorPicture ours = render(left, disparity, kBaselineM);
    const ColorPicture plain = warpedAndInpainted(left, disparity);
    std::printf("%s: seen %.2f dB, hidden %.2f, all %.2f; warp and Telea %.2f, %.2f, %.2f\n",
                scene.name, psnr(ours, right, seen), psnr(ours, right, hidden),
                psnr(ours, right, all), psnr(plain, right, seen), psnr(plain, right, hidden),
                psnr(plain, right, all));
    EXPECT_GE(psnr(ours, right, seen), scene.leastSeenDb);
    EXPECT_GE(psnr(ours, right, all), scene.leastAllDb);
    EXPECT_GE(psnr(ours, right, all), psnr(plain, right, all) + scene.leastGainDb);
    int black = 0;
    for (std::size_t i = 0; i < ours.rgb.size(); i += 3)
        black += ours.rgb[i] + ours.rgb[i + 1] + ours.rgb[i + 2] == 0 ? 1 : 0;
    int blackThere = 0;
    for (std::size_t i = 0; i < left.rgb.size(); i += 3)
        blackThere += left.rgb[i] + left.rgb[i + 1] + left.rgb[i + 2] == 0 ? 1 : 0;
    EXPECT_LE(black, 2 * blackThere + 10) << "pixels that show nothing are black";
}

INSTANTIATE_TEST_SUITE_P(
    Middlebury, MovedCamera,
    testing::Values(Scene{"cones", "im2.png", "im6.png", "disp2.png", "disp6.png", 4, 30.3, 24.6,
                          0.5},
                    Scene{"art", "view1.png", "view5.png", "disp1.png", "disp5.png", 3, 0, 0, -1},
                    Scene{"books", "view1.png", "view5.png", "disp1.png", "disp5.png", 3, 0, 0, -1},
                    Scene{"dolls", "view1.png", "view5.png", "disp1.png", "disp5.png", 3, 0, 0, -1},
                    Scene{"aloe", "aloeL.jpg", "aloeR.jpg", "aloeGT.png", nullptr, 1, 0, 0, 0.5}),
    [](const auto& scene) { return scene.param.name; });

} // namespace
} // namespace autostereo::test

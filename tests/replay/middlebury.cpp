#include "tests/replay/middlebury.hpp"

#include "devices/replay/image_files.hpp"

#include <opencv2/photo.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace autostereo::test {

namespace {

/// A binary PGM as RGB: devices know no such files.
ColorPicture readPgm(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string magic;
    int largest = 0;
    ColorPicture picture;
    in >> magic >> picture.width >> picture.height >> largest;
    in.get();
    if (!in || magic != "P5" || largest != 255)
        throw std::runtime_error(file.string() + ": no PGM");
    for (int i = 0; i < picture.width * picture.height; ++i)
        picture.rgb.insert(picture.rgb.end(), 3, static_cast<std::uint8_t>(in.get()));
    if (!in) throw std::runtime_error(file.string() + ": too short");
    return picture;
}

ColorPicture readAny(const std::filesystem::path& file) {
    if (file.extension() == ".pgm") return readPgm(file);
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

ColorPicture readWithin(const std::filesystem::path& file, int border) {
    const ColorPicture whole = readAny(file);
    ColorPicture picture{whole.width - 2 * border, whole.height - 2 * border, {}};
    for (int y = 0; y < picture.height; ++y) {
        const auto* row = whole.at(border, y + border);
        picture.rgb.insert(picture.rgb.end(), row, row + 3 * picture.width);
    }
    return picture;
}

Plane disparityOf(const ColorPicture& grey, int greyPerPixel) {
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

void warpRow(const std::vector<double>& row, double baselines, std::vector<double>& source,
             std::vector<double>& disparity) {
    for (std::size_t u = 0; u + 1 < row.size(); ++u) {
        const double a = static_cast<double>(u) - baselines * row[u];
        const double b = static_cast<double>(u + 1) - baselines * row[u + 1];
        const bool known = row[u] > 0 && row[u + 1] > 0;
        if (!known || std::abs(baselines * (row[u] - row[u + 1])) > 1 || b <= a) continue;
        const int last = static_cast<int>(std::floor(b));
        for (int x = std::max(0, static_cast<int>(std::ceil(a)));
             x <= std::min(static_cast<int>(row.size()) - 1, last); ++x) {
            const double t = (x - a) / (b - a), d = row[u] + t * (row[u + 1] - row[u]);
            const auto at = static_cast<std::size_t>(x);
            if (d <= disparity[at]) continue;
            disparity[at] = d;
            source[at] = static_cast<double>(u) + t;
        }
    }
}

/// A hole takes the pixel at the end of it that is farther from the camera.
void repeatRow(ColorPicture& picture, const Warp& warped, int y) {
    const auto& disparity = warped.disparity[static_cast<std::size_t>(y)];
    const auto end = [&](int x, int step) {
        while (x >= 0 && x < picture.width && disparity[static_cast<std::size_t>(x)] == 0)
            x += step;
        return x;
    };
    const ColorPicture before = picture;
    for (int x = 0; x < picture.width; ++x) {
        const int left = end(x, -1), right = end(x, 1);
        if (left == x || (left < 0 && right >= picture.width)) continue;
        const bool leftIsFarther =
            left >= 0 && (right >= picture.width || disparity[static_cast<std::size_t>(left)] <=
                                                        disparity[static_cast<std::size_t>(right)]);
        std::copy_n(before.at(leftIsFarther ? left : right, y), 3,
                    picture.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * picture.width + x));
    }
}

} // namespace

Warp warp(const Plane& disparity, double baselines) {
    Warp warped;
    for (const auto& row : disparity) {
        warped.source.emplace_back(row.size(), -1);
        warped.disparity.emplace_back(row.size(), 0);
        warpRow(row, baselines, warped.source.back(), warped.disparity.back());
    }
    return warped;
}

StereoTruth::StereoTruth(const StereoPair& pair, const std::filesystem::path& folder)
    : left(readWithin(folder / pair.left, pair.border)),
      right(readWithin(folder / pair.right, pair.border)), baselines_(pair.baselines),
      known_(disparityOf(readWithin(folder / pair.leftDisparity, pair.border), pair.greyPerPixel)) {
    disparity = withoutHoles(known_);
    other_ =
        pair.rightDisparity != nullptr
            ? disparityOf(readWithin(folder / pair.rightDisparity, pair.border), pair.greyPerPixel)
            : warp(known_, baselines_).disparity;
    otherFilled_ = withoutHoles(other_);
}

bool StereoTruth::seen(int x, int y) const {
    const double d = other_[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
    const auto& row = known_[static_cast<std::size_t>(y)];
    const long u = std::lround(x + baselines_ * d);
    if (!(d > 0) || u < 0 || u >= static_cast<long>(row.size())) return false;
    const double there = row[static_cast<std::size_t>(u)];
    return there > 0 && std::abs(baselines_ * (there - d)) <= 1;
}

bool StereoTruth::outOfFrame(int x, int y) const {
    const double d = otherFilled_[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
    const double u = x + baselines_ * d;
    return u < -0.5 || u > left.width - 0.5;
}

ColorPicture plainWarp(const StereoTruth& truth, double baselines, HoleFilling filling) {
    const Warp warped = warp(truth.disparity, baselines);
    ColorPicture picture = truth.left;
    cv::Mat pixels(picture.height, picture.width, CV_8UC3, picture.rgb.data());
    cv::Mat holes(picture.height, picture.width, CV_8UC1, cv::Scalar(1)), result;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double u =
                warped.source[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
            if (u < 0) continue;
            holes.at<std::uint8_t>(y, x) = 0;
            const auto color = cubic(truth.left, u, y);
            for (int c = 0; c < 3; ++c)
                pixels.at<cv::Vec3b>(y, x)[c] =
                    cv::saturate_cast<std::uint8_t>(color[static_cast<std::size_t>(c)]);
        }
    if (filling == HoleFilling::Telea) {
        cv::inpaint(pixels, holes, result, 3, cv::INPAINT_TELEA);
        return {picture.width, picture.height, {result.datastart, result.dataend}};
    }
    for (int y = 0; y < picture.height; ++y)
        repeatRow(picture, warped, y);
    return picture;
}

} // namespace autostereo::test

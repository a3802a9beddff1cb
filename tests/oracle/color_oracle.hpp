#pragma once

#include "devices/frame.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

// Slow, obvious, double-precision twin of ColorConverter, from the standards' own definitions: Y is
// the weighted sum of R, G, B, and Cb, Cr are B - Y, R - Y scaled to the range of Y.

namespace autostereo::oracle {

struct ColorFrame {
    devices::FrameMetadata form;
    std::span<const std::byte> bytes;

    [[nodiscard]] double at(std::size_t i) const { return std::to_integer<int>(bytes[i]); }
};

/// R, G, B as 0..255, not rounded.
inline std::array<double, 3> rgbOf(const devices::FrameMetadata& form, double y, double cb,
                                   double cr) {
    const bool hd = form.matrix == devices::YuvMatrix::Auto
                        ? form.height >= 720
                        : form.matrix == devices::YuvMatrix::Bt709;
    const double wr = hd ? 0.2126 : 0.299, wb = hd ? 0.0722 : 0.114;
    const bool full = form.range == devices::YuvRange::Full;
    const double luma = full ? y / 255 : (y - 16) / 219;
    const double blueLess = (cb - 128) / (full ? 255 : 224);
    const double redLess = (cr - 128) / (full ? 255 : 224);
    const double blue = luma + blueLess * 2 * (1 - wb);
    const double red = luma + redLess * 2 * (1 - wr);
    const double green = (luma - wr * red - wb * blue) / (1 - wr - wb);
    std::array<double, 3> rgb{red, green, blue};
    for (double& channel : rgb)
        channel = 255 * std::clamp(channel, 0.0, 1.0);
    return rgb;
}

/// A chroma sample of the grid: `second` is Cr.
inline double chroma(const ColorFrame& in, int i, int j, bool second) {
    const int pairs = in.form.width / 2;
    const auto column = static_cast<std::size_t>(std::clamp(i, 0, pairs - 1));
    const auto width = static_cast<std::size_t>(in.form.width);
    if (in.form.format == devices::PixelFormat::Nv12) {
        const auto row = static_cast<std::size_t>(std::clamp(j, 0, in.form.height / 2 - 1));
        return in.at(width * static_cast<std::size_t>(in.form.height) + row * width + 2 * column +
                     (second ? 1 : 0));
    }
    const std::size_t first = in.form.format == devices::PixelFormat::Uyvy ? 0 : 1;
    return in.at(static_cast<std::size_t>(j) * 2 * width + 4 * column + first + (second ? 2 : 0));
}

/// Interpolated at a luma pixel: samples lie at x = 2i and, in NV12, at y = 2j + 1/2.
inline double chromaAt(const ColorFrame& in, int x, int y, bool second) {
    const auto inRow = [&](int j) {
        const double own = chroma(in, x / 2, j, second);
        return x % 2 == 0 ? own : (own + chroma(in, x / 2 + 1, j, second)) / 2;
    };
    if (in.form.format != devices::PixelFormat::Nv12) return inRow(y);
    const double place = (y - 0.5) / 2;
    const int above = y % 2 == 0 ? y / 2 - 1 : y / 2;
    const double below = place - above;
    return (1 - below) * inRow(above) + below * inRow(above + 1);
}

inline std::array<double, 3> convertedColor(const ColorFrame& in, int x, int y) {
    using devices::PixelFormat;
    const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(in.form.width) +
                       static_cast<std::size_t>(x);
    switch (in.form.format) {
    case PixelFormat::Grey8:
        return {in.at(pixel), in.at(pixel), in.at(pixel)};
    case PixelFormat::Rgb8:
        return {in.at(3 * pixel), in.at(3 * pixel + 1), in.at(3 * pixel + 2)};
    case PixelFormat::Bgr8:
        return {in.at(3 * pixel + 2), in.at(3 * pixel + 1), in.at(3 * pixel)};
    case PixelFormat::Bgra8:
        return {in.at(4 * pixel + 2), in.at(4 * pixel + 1), in.at(4 * pixel)};
    case PixelFormat::Yuyv:
    case PixelFormat::Uyvy:
    case PixelFormat::Nv12:
        break;
    default:
        return {in.at(4 * pixel), in.at(4 * pixel + 1), in.at(4 * pixel + 2)};
    }
    const double luma = in.form.format == PixelFormat::Nv12   ? in.at(pixel)
                        : in.form.format == PixelFormat::Yuyv ? in.at(2 * pixel)
                                                              : in.at(2 * pixel + 1);
    return rgbOf(in.form, luma, chromaAt(in, x, y, false), chromaAt(in, x, y, true));
}

} // namespace autostereo::oracle

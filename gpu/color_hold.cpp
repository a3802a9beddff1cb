#include "gpu/color_hold.hpp"

#include "gpu/dirty/block_marks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace autostereo::gpu {

namespace {

using devices::PixelFormat;

/// What noise does once in 10^9 times, in standard deviations.
constexpr double kRare = 6;

struct Layout {
    std::size_t bytesPerPixel, period; ///< bytes from a channel to the same one
};

Layout layoutOf(PixelFormat format) {
    switch (format) {
    case PixelFormat::Rgb8:
    case PixelFormat::Bgr8:
        return {3, 3};
    case PixelFormat::Grey8:
    case PixelFormat::Nv12: // its luma
        return {1, 1};
    case PixelFormat::Yuyv:
    case PixelFormat::Uyvy:
        return {2, 4};
    case PixelFormat::Depth16:
    case PixelFormat::Rgba8:
    case PixelFormat::Bgra8:
        break;
    }
    return {4, 4};
}

} // namespace

/// Rows of bytes of which so many belong to a block of pixels.
struct ColorHold::Plane {
    std::size_t first, rowBytes, rows; ///< first byte
    std::size_t blockBytes, blockRows; ///< of a block
    std::size_t period;
};

bool ColorHold::update(const devices::Frame& frame) {
    const devices::FrameMetadata& form = frame.metadata();
    const auto width = static_cast<std::size_t>(form.width);
    const auto height = static_cast<std::size_t>(form.height);
    if (form.format != form_.format || form.width != form_.width || form.height != form_.height ||
        form.matrix != form_.matrix || form.range != form_.range || kept_.empty()) {
        restart(frame);
        return true;
    }
    const auto [bytesPerPixel, period] = layoutOf(form.format);
    constexpr std::size_t kBlock = BlockMarks::kBlock;
    std::ranges::fill(renewed_, std::uint8_t{0});
    const std::size_t rowBytes = width * bytesPerPixel;
    bool any =
        updatePlane({0, rowBytes, height, kBlock * bytesPerPixel, kBlock, period}, frame.pixels());
    if (form.format == PixelFormat::Nv12)
        any |= updatePlane({rowBytes * height, rowBytes, height / 2, kBlock, kBlock / 2, 2},
                           frame.pixels());
    blocksSeen_ += renewed_.size();
    blocksKept_ += static_cast<std::uint64_t>(std::ranges::count(renewed_, std::uint8_t{0}));
    return any;
}

void ColorHold::restart(const devices::Frame& frame) {
    form_ = frame.metadata();
    const auto pixels = frame.pixels();
    kept_.assign(pixels.begin(), pixels.end());
    const auto across = static_cast<std::size_t>(BlockMarks::blocksOf(form_.width));
    renewed_.assign(across * static_cast<std::size_t>(BlockMarks::blocksOf(form_.height)), 1);
    blocksSeen_ += renewed_.size();
}

bool ColorHold::updatePlane(const Plane& plane, std::span<const std::byte> pixels) {
    sums_.resize(plane.rowBytes);
    squares_.resize(plane.rowBytes);
    worst_.resize(plane.rowBytes);
    bool any = false;
    const auto across = static_cast<std::size_t>(BlockMarks::blocksOf(form_.width));
    for (std::size_t band = 0; band * plane.blockRows < plane.rows; ++band) {
        const std::size_t top = band * plane.blockRows;
        const std::size_t rows = std::min(plane.blockRows, plane.rows - top);
        const std::size_t begin = plane.first + top * plane.rowBytes;
        if (std::memcmp(&pixels[begin], &kept_[begin], rows * plane.rowBytes) == 0) continue;
        std::ranges::fill(sums_, std::int16_t{0});
        std::ranges::fill(squares_, 0U);
        std::ranges::fill(worst_, std::uint8_t{0});
        for (std::size_t row = 0; row < rows; ++row) {
            const std::size_t start = begin + row * plane.rowBytes;
            judgeRow(&pixels[start], &kept_[start], plane.rowBytes);
        }
        for (std::size_t block = 0; block < across; ++block) {
            const std::size_t left = block * plane.blockBytes;
            const std::size_t bytes = std::min(plane.blockBytes, plane.rowBytes - left);
            if (isNoise(left, bytes, plane.period, rows)) continue;
            for (std::size_t row = 0; row < rows; ++row) {
                const std::size_t start = begin + row * plane.rowBytes + left;
                std::memcpy(&kept_[start], &pixels[start], bytes);
            }
            renewed_[band * across + block] = 1;
            any = true;
        }
    }
    return any;
}

void ColorHold::judgeRow(const std::byte* now, const std::byte* kept, std::size_t bytes) {
    std::int16_t* const sums = sums_.data();
    std::uint32_t* const squares = squares_.data();
    std::uint8_t* const worst = worst_.data();
    for (std::size_t i = 0; i < bytes; ++i) {
        const int off = std::to_integer<int>(now[i]) - std::to_integer<int>(kept[i]);
        sums[i] = static_cast<std::int16_t>(sums[i] + off);
        squares[i] += static_cast<std::uint32_t>(off * off);
        worst[i] = std::max(worst[i], static_cast<std::uint8_t>(std::abs(off)));
    }
}

bool ColorHold::isNoise(std::size_t left, std::size_t bytes, std::size_t period,
                        std::size_t rows) const {
    const auto end = left + bytes;
    const auto worst = *std::max_element(worst_.begin() + static_cast<std::ptrdiff_t>(left),
                                         worst_.begin() + static_cast<std::ptrdiff_t>(end));
    if (worst == 0) return true;
    // Of the difference of two noisy bytes, each of which was rounded.
    const double variance = 2 * (params_.sigma * params_.sigma + 1.0 / 12);
    if (params_.sigma == 0 || worst > kRare * std::sqrt(variance)) return false;
    double squares = 0;
    for (std::size_t channel = 0; channel < period; ++channel) {
        double sum = 0, number = 0;
        for (std::size_t i = left + channel; i < end; i += period) {
            sum += sums_[i];
            squares += squares_[i];
            number += static_cast<double>(rows);
        }
        if (sum * sum > kRare * kRare * variance * number) return false;
    }
    const auto number = static_cast<double>(bytes * rows);
    return squares <= variance * (number + kRare * std::sqrt(2 * number));
}

} // namespace autostereo::gpu

#include "tests/bench/views/judge.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::bench {

namespace {

/// Of one block: 64 pairs of levels.
double blockSsim(const std::array<double, 64>& a, const std::array<double, 64>& b) {
    constexpr double kC1 = 0.01 * 255 * 0.01 * 255, kC2 = 0.03 * 255 * 0.03 * 255;
    double meanA = 0, meanB = 0, aa = 0, bb = 0, ab = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        meanA += a[i] / 64;
        meanB += b[i] / 64;
        aa += a[i] * a[i] / 64;
        bb += b[i] * b[i] / 64;
        ab += a[i] * b[i] / 64;
    }
    const double varianceA = aa - meanA * meanA, varianceB = bb - meanB * meanB;
    return (2 * meanA * meanB + kC1) * (2 * (ab - meanA * meanB) + kC2) /
           ((meanA * meanA + meanB * meanB + kC1) * (varianceA + varianceB + kC2));
}

} // namespace

Judge::Judge(const oracle::SearchInput& in, const oracle::SearchedPanel& panel, int width,
             int height, int bands)
    : width_(width), height_(height), bands_(std::min(bands, height / kBandRows)) {
    levels_.reserve(static_cast<std::size_t>(bands_ * kBandRows) * static_cast<std::size_t>(3) *
                    static_cast<std::size_t>(width));
    for (int band = 0; band < bands_; ++band)
        for (int y = firstRow(band); y < firstRow(band) + kBandRows; ++y)
            for (int x = 0; x < width; ++x)
                for (int c = 0; c < 3; ++c)
                    levels_.push_back(panel.level(in, x, y, c));
}

int Judge::firstRow(int band) const {
    return static_cast<int>((band + 0.5) * height_ / bands_) - kBandRows / 2;
}

Judgement Judge::judge(const gpu::RgbImage& image) const {
    const auto rowLength = static_cast<std::size_t>(3) * static_cast<std::size_t>(width_);
    Judgement found;
    double squares = 0, ssim = 0;
    std::size_t bad = 0, blocks = 0;
    for (int band = 0; band < bands_; ++band) {
        const double* truth =
            levels_.data() + static_cast<std::size_t>(band) * kBandRows * rowLength;
        const std::uint8_t* shown =
            image.pixels.data() + static_cast<std::size_t>(firstRow(band)) * rowLength;
        for (std::size_t i = 0; i < kBandRows * rowLength; ++i) {
            const double off = std::abs(shown[i] - truth[i]);
            squares += off * off;
            found.errMax = std::max(found.errMax, off);
            if (off > 16) ++bad;
        }
        for (int left = 0; left + 8 <= width_; left += 8)
            for (std::size_t c = 0; c < 3; ++c, ++blocks) {
                std::array<double, 64> a{}, b{};
                for (std::size_t i = 0; i < 64; ++i) {
                    const std::size_t at =
                        i / 8 * rowLength + 3 * (static_cast<std::size_t>(left) + i % 8) + c;
                    a[i] = shown[at];
                    b[i] = truth[at];
                }
                ssim += blockSsim(a, b);
            }
    }
    const auto samples = static_cast<double>(std::max<std::size_t>(1, levels_.size()));
    found.psnrDb = 10 * std::log10(255 * 255 / std::max(squares / samples, 1e-9));
    found.ssim = ssim / static_cast<double>(std::max<std::size_t>(1, blocks));
    found.badPct = 100 * static_cast<double>(bad) / samples;
    return found;
}

} // namespace autostereo::bench

#include "calib/depth_noise.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace autostereo::calib {

namespace {

constexpr std::size_t kApart = 2;    // frames
constexpr double kBinsPerOctave = 4; // sigma changes by 19 % (amplitude) or 41 % (range) in one
constexpr std::size_t kBins = 16 * 4 + 1;      // of 16-bit numbers
constexpr std::size_t kFewest = 300;           // differences; their median is then good to 7 %
constexpr double kRoundingVariance = 1.0 / 12; // counts^2

/// Absolute differences of pixels alike, and the mean of what their variance should follow.
struct Bin {
    std::vector<std::uint16_t> differences;
    double regressorSum = 0;
};
using Bins = std::array<Bin, kBins>;

/// One bin's verdict: variance = floor^2 + slope * regressor.
struct Point {
    double regressor;
    double variance; ///< m^2
    double samples;
};

std::size_t binOf(double number) {
    const double bin = kBinsPerOctave * std::log2(std::fmax(number, 1.0));
    return std::min(static_cast<std::size_t>(bin), kBins - 1);
}

bool isMeasured(std::uint16_t count) { return count != 0 && count != 65535; }

/// Median of whole numbers that were rounded: taken as spread evenly over the half to either side.
double medianOf(std::vector<std::uint16_t>& numbers) {
    const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
    std::nth_element(numbers.begin(), middle, numbers.end());
    const std::uint16_t median = *middle;
    const auto below = std::ranges::count_if(numbers, [&](auto n) { return n < median; });
    const auto equal = std::ranges::count(numbers, median);
    const double share = (static_cast<double>(numbers.size()) / 2 - static_cast<double>(below)) /
                         static_cast<double>(equal);
    return median == 0 ? share / 2 : median - 0.5 + share;
}

/// Standard deviation of a bin's differences; none where many of them are no noise at all (edges,
/// flying pixels): each round drops what lies beyond five sigma, and what is left must be the most.
std::optional<double> sigmaOf(std::vector<std::uint16_t>& differences) {
    constexpr double kMedianOfGaussian = 0.674490; // of |x|, sigma 1
    constexpr double kFarthest = 5;                // sigma
    constexpr double kLeastShare = 0.85;
    constexpr int kRounds = 4;
    const auto all = static_cast<double>(differences.size());
    double sigma = 0;
    for (int round = 0; round < kRounds; ++round) {
        sigma = medianOf(differences) / kMedianOfGaussian;
        std::erase_if(differences, [&](auto d) { return d > kFarthest * sigma + 1; });
    }
    if (static_cast<double>(differences.size()) < kLeastShare * all) return std::nullopt;
    return sigma;
}

std::vector<Point> pointsOf(Bins& bins, double depthUnitM) {
    std::vector<Point> points;
    for (Bin& bin : bins) {
        const auto samples = static_cast<double>(bin.differences.size());
        if (bin.differences.size() < kFewest) continue;
        const auto sigma = sigmaOf(bin.differences); // of the difference of two measurements
        const double variance = sigma ? *sigma * *sigma / 2 - kRoundingVariance : 0;
        if (!(variance > 0)) continue; // less than the rounding: nothing to be seen
        const double squareM = variance * depthUnitM * depthUnitM;
        points.push_back({bin.regressorSum / samples, squareM, samples});
    }
    return points;
}

/// Three bins or more, their regressors a factor of four apart or more.
bool supportsALine(const std::vector<Point>& points) {
    if (points.size() < 3) return false;
    const auto [least, most] = std::ranges::minmax_element(points, {}, &Point::regressor);
    return most->regressor >= 4 * least->regressor;
}

struct Line {
    double atZero = 0;
    double slope = 0;
};

/// Weighted least squares; neither part is negative. With `atZero` given, the slope alone.
Line fitted(const std::vector<Point>& points, std::optional<double> atZero) {
    double w = 0, wx = 0, wy = 0, wxx = 0, wxy = 0;
    for (const Point& point : points) {
        const double weight = point.samples / (point.variance * point.variance);
        w += weight;
        wx += weight * point.regressor;
        wy += weight * point.variance;
        wxx += weight * point.regressor * point.regressor;
        wxy += weight * point.regressor * point.variance;
    }
    const double determinant = w * wxx - wx * wx;
    if (!atZero && determinant > 0) atZero = std::fmax(0, (wxx * wy - wx * wxy) / determinant);
    const double slope = (wxy - atZero.value_or(0) * wx) / wxx;
    if (slope < 0) return {wy / w, 0};
    return {atZero.value_or(0), slope};
}

double offFrom(const Line& line, const Point& point) {
    return std::sqrt(point.variance / (line.atZero + line.slope * point.regressor)) - 1;
}

double residualOf(const std::vector<Point>& points, const Line& line) {
    double squares = 0, weights = 0;
    for (const Point& point : points) {
        squares += point.samples * offFrom(line, point) * offFrom(line, point);
        weights += point.samples;
    }
    return std::sqrt(squares / weights);
}

struct Fit {
    Line line;
    double residual;
};

/// The line through the bins, without those where most pixels stand at an edge: their differences
/// are flying pixels, many times the noise. None where the rest supports no line.
std::optional<Fit> fitOf(Bins& bins, double depthUnitM, std::optional<double> atZero) {
    constexpr double kFarOff = 0.5;
    constexpr int kRounds = 3;
    std::vector<Point> points = pointsOf(bins, depthUnitM);
    for (int round = 0; round < kRounds && supportsALine(points); ++round) {
        const Line line = fitted(points, atZero);
        const auto isOff = [&](const Point& point) { return offFrom(line, point) > kFarOff; };
        if (std::erase_if(points, isOff) == 0) return Fit{line, residualOf(points, line)};
    }
    return std::nullopt;
}

void collect(const StillFrame& a, const StillFrame& b, double depthUnitM, Bins& byAmplitude,
             Bins& byRange) {
    const std::size_t pixels = std::min(a.depth.size(), b.depth.size());
    const bool hasAmplitude = a.amplitude.size() >= pixels && b.amplitude.size() >= pixels;
    for (std::size_t i = 0; i < pixels; ++i) {
        if (!isMeasured(a.depth[i]) || !isMeasured(b.depth[i])) continue;
        const auto difference = static_cast<std::uint16_t>(std::abs(a.depth[i] - b.depth[i]));
        const double count = 0.5 * (a.depth[i] + b.depth[i]);
        const double z = count * depthUnitM;
        Bin& range = byRange[binOf(count)];
        range.differences.push_back(difference);
        range.regressorSum += z * z * z * z;
        if (!hasAmplitude || a.amplitude[i] == 0 || b.amplitude[i] == 0) continue;
        const double amplitude = 0.5 * (a.amplitude[i] + b.amplitude[i]);
        Bin& counts = byAmplitude[binOf(amplitude)];
        counts.differences.push_back(difference);
        counts.regressorSum += 1 / (amplitude * amplitude);
    }
}

} // namespace

std::optional<NoiseFit> measureDepthNoise(std::span<const StillFrame> frames, double depthUnitM) {
    Bins byAmplitude, byRange;
    for (std::size_t i = 0; i + kApart < frames.size(); ++i)
        collect(frames[i], frames[i + kApart], depthUnitM, byAmplitude, byRange);
    const auto amplitude = fitOf(byAmplitude, depthUnitM, std::nullopt);
    const auto range = fitOf(byRange, depthUnitM,
                             amplitude ? std::optional(amplitude->line.atZero) : std::nullopt);
    if (!amplitude && !range) return std::nullopt;
    NoiseFit fit;
    fit.noise.floorM = std::sqrt((amplitude ? amplitude : range)->line.atZero);
    if (amplitude) {
        fit.noise.shotM = std::sqrt(amplitude->line.slope);
        fit.amplitudeResidual = amplitude->residual;
    }
    if (range) {
        fit.noise.growthPerM = std::sqrt(range->line.slope);
        fit.rangeResidual = range->residual;
    }
    return fit;
}

} // namespace autostereo::calib

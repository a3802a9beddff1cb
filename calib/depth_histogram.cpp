#include "calib/depth_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace autostereo::calib {

namespace {

double depthAt(double bins) {
    return DepthHistogram::kNearestM * std::exp2(bins / DepthHistogram::kBinsPerOctave);
}

double middleOf(std::size_t bin) { return depthAt(static_cast<double>(bin) + 0.5); }

} // namespace

DepthHistogram::DepthHistogram(std::span<const std::uint32_t> counts)
    : counts_(counts.begin(), counts.end()),
      total_(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0})) {}

std::size_t DepthHistogram::binOf(double z) {
    const double bin = std::floor(std::log2(z / kNearestM) * kBinsPerOctave);
    return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(kBins - 1)));
}

std::optional<double> DepthHistogram::quantile(double share) const {
    if (total_ == 0) return std::nullopt;
    const double wanted = std::clamp(share, 0.0, 1.0) * static_cast<double>(total_);
    double before = 0;
    std::size_t last = 0;
    for (std::size_t bin = 0; bin < counts_.size(); ++bin) {
        if (counts_[bin] == 0) continue;
        const double here = counts_[bin];
        if (before + here >= wanted)
            return depthAt(static_cast<double>(bin) + (wanted - before) / here);
        before += here;
        last = bin;
    }
    return depthAt(static_cast<double>(last) + 1); // sums that rounding left short
}

double DepthHistogram::shareBetween(double nearM, double farM) const {
    if (total_ == 0) return 0;
    std::uint64_t inside = 0;
    for (std::size_t bin = 0; bin < counts_.size(); ++bin)
        if (middleOf(bin) >= nearM && middleOf(bin) <= farM) inside += counts_[bin];
    return static_cast<double>(inside) / static_cast<double>(total_);
}

DepthHistogram DepthHistogram::upTo(double farM) const {
    std::vector<std::uint32_t> kept = counts_;
    for (std::size_t bin = 0; bin < kept.size(); ++bin)
        if (middleOf(bin) > farM) kept[bin] = 0;
    return DepthHistogram(kept);
}

} // namespace autostereo::calib

#include "calib/depth_histogram.hpp"
#include "tests/unit/calib/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace autostereo::calib {
namespace {

DepthHistogram of(const std::vector<double>& depths) {
    std::vector<std::uint32_t> counts(DepthHistogram::kBins);
    for (const double z : depths)
        ++counts[DepthHistogram::binOf(z)];
    return DepthHistogram(counts);
}

/// One bin's width is 1.1 %; within it depths are taken to be spread evenly.
constexpr double kBin = 0.011;

TEST(DepthHistogram, QuantilesAreThoseOfTheDepths) {
    RandomNumbers random(41);
    std::vector<double> depths(20000);
    std::ranges::generate(depths, [&] { return std::exp(random.between(-2.5, 3.5)); });
    const DepthHistogram histogram = of(depths);
    EXPECT_EQ(histogram.total(), depths.size());
    std::ranges::sort(depths);
    for (const double share : {0.01, 0.05, 0.3, 0.5, 0.95, 0.999}) {
        const double exact = depths[static_cast<std::size_t>(share * 19999)];
        EXPECT_NEAR(histogram.quantile(share).value() / exact, 1, kBin) << share;
    }
}

TEST(DepthHistogram, EndsAreThoseOfWhatWasCounted) {
    const DepthHistogram histogram = of({1.5, 1.5, 3});
    EXPECT_NEAR(histogram.quantile(0).value(), 1.5, 1.5 * kBin);
    EXPECT_NEAR(histogram.quantile(0.5).value(), 1.5, 1.5 * kBin);
    EXPECT_NEAR(histogram.quantile(1).value(), 3, 3 * kBin);
    EXPECT_NEAR(histogram.quantile(7).value(), 3, 3 * kBin);
}

TEST(DepthHistogram, OfNothingSaysNothing) {
    const DepthHistogram nothing = of({});
    EXPECT_FALSE(nothing.quantile(0.5));
    EXPECT_EQ(nothing.shareBetween(0, 100), 0);
}

TEST(DepthHistogram, DepthsOutsideItCountAtItsEnds) {
    EXPECT_EQ(DepthHistogram::binOf(0.001), 0U);
    EXPECT_EQ(DepthHistogram::binOf(1e6), DepthHistogram::kBins - 1);
    EXPECT_EQ(DepthHistogram::binOf(102.3), DepthHistogram::kBins - 1);
    EXPECT_EQ(DepthHistogram::binOf(0.1001), 64U);
}

TEST(DepthHistogram, SharesAndCuts) {
    const DepthHistogram histogram = of({1, 1, 2, 4});
    EXPECT_DOUBLE_EQ(histogram.shareBetween(0.9, 2.1), 0.75);
    EXPECT_DOUBLE_EQ(histogram.shareBetween(1.5, 1e9), 0.5);
    const DepthHistogram nearer = histogram.upTo(3);
    EXPECT_EQ(nearer.total(), 3U);
    EXPECT_NEAR(nearer.quantile(1).value(), 2, 2 * kBin);
}

} // namespace
} // namespace autostereo::calib

#include "daemon/session/percentiles.hpp"

#include <gtest/gtest.h>

namespace autostereo::daemon {
namespace {

TEST(Percentiles, AreNoneWithoutSamples) {
    const Percentiles none;
    EXPECT_FALSE(none.at(0.5));
    EXPECT_FALSE(none.at(0));
    EXPECT_FALSE(none.at(1));
}

TEST(Percentiles, TakeTheNearestRankInAnyOrder) {
    Percentiles samples;
    for (int i = 0; i <= 100; ++i)
        samples.add(i * 37 % 101); // 0 to 100, shuffled
    EXPECT_EQ(samples.at(0), 0);
    EXPECT_EQ(samples.at(0.5), 50);
    EXPECT_EQ(samples.at(0.99), 99);
    EXPECT_EQ(samples.at(1), 100);
}

TEST(Percentiles, OneSampleIsAllOfThem) {
    Percentiles samples;
    samples.add(7.5);
    for (const double share : {0.0, 0.5, 0.99, 1.0})
        EXPECT_EQ(samples.at(share), 7.5);
}

TEST(Percentiles, ForgetTheOldest) {
    Percentiles samples;
    for (int i = 0; i < 4096; ++i)
        samples.add(1000);
    EXPECT_EQ(samples.at(0), 1000);
    samples.add(1);
    EXPECT_EQ(samples.at(0), 1); // took the place of one
    EXPECT_EQ(samples.at(0.01), 1000);
    for (int i = 0; i < 4095; ++i)
        samples.add(1);
    EXPECT_EQ(samples.at(1), 1); // of the first 4096 none is left
}

} // namespace
} // namespace autostereo::daemon

#include "devices/tracking/one_euro.hpp"
#include "tests/oracle/one_euro_oracle.hpp"
#include "tests/unit/tracking/eye_times.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace autostereo::test {
namespace {

using devices::OneEuro;
using devices::OneEuroParams;

TEST(OneEuro, IsThePapersFilterWithItsLagPutRight) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> step(0.002, 0.05), place(-0.5, 0.5);
    const OneEuroParams params{3, 25, 5, 0.02};
    for (int run = 0; run < 50; ++run) {
        std::vector<oracle::LineSample> samples;
        std::optional<OneEuro> filter;
        const glm::dvec3 along = glm::normalize(glm::dvec3{1, -2, 0.5});
        long double nanoseconds = 0;
        double where = 0;
        for (int i = 0; i < 40; ++i) {
            nanoseconds += std::floor(1e9L * step(random));
            where += 0.1 * place(random);
            const devices::TimePoint at =
                atSeconds(0) + devices::Duration(static_cast<std::int64_t>(nanoseconds));
            samples.push_back({nanoseconds * 1e-9L, where});
            if (filter)
                filter->add(at, along * where);
            else
                filter.emplace(params, at, along * where);
        }
        const oracle::Smoothed expected = oracle::oneEuro(samples, {3, 25, 5});
        const long double square = expected.velocity * expected.velocity;
        const long double belief = square / (square + 0.02L * 0.02L);
        const double ahead = 0.04;
        const auto last = atSeconds(0) + devices::Duration(static_cast<std::int64_t>(nanoseconds));
        const long double truth =
            expected.place + expected.velocity * belief * (ahead + expected.lag);
        const glm::dvec3 found = filter->at(last + devices::Duration(40'000'000));
        // Rounding of doubles: speeds of some m/s from steps of 2 ms.
        EXPECT_NEAR(glm::dot(found, along), static_cast<double>(truth), 1e-11);
        EXPECT_NEAR(glm::length(glm::cross(found, along)), 0, 1e-11);
    }
}

TEST(OneEuro, ASteadyWalkIsMetAheadOfTime) {
    for (const double speed : {0.5, 1.5}) {
        const glm::dvec3 velocity{speed, 0, -0.1 * speed};
        OneEuro filter(OneEuroParams{}, atSeconds(0), {-0.4, 0, 0.7});
        for (int i = 1; i <= 100; ++i)
            filter.add(atSeconds(0.01 * i), glm::dvec3{-0.4, 0, 0.7} + velocity * (0.01 * i));
        const glm::dvec3 truth = glm::dvec3{-0.4, 0, 0.7} + velocity * 1.03;
        // restSpeed^2 / speed^2 is not believed: 1.4 % of some 37 ms at 0.5 m/s.
        EXPECT_LT(glm::length(filter.at(atSeconds(1.03)) - truth), 3e-4) << speed;
        EXPECT_GT(glm::length(filter.at(atSeconds(1)) - truth), 0.02 * speed) << speed;
    }
}

/// Of a viewer at rest, 30 ms ahead, root mean square, for 1 mm of the tracker's.
double noiseAhead(const OneEuroParams& params) {
    std::mt19937 random(4);
    std::normal_distribution<double> noise(0, 0.001);
    OneEuro filter(params, atSeconds(0), {0, 0, 0.65});
    double squares = 0;
    constexpr int kSamples = 2000;
    for (int i = 1; i <= kSamples; ++i) {
        filter.add(atSeconds(0.01 * i), {noise(random), 0, 0.65});
        const double off = filter.at(atSeconds(0.01 * i + 0.03)).x;
        squares += off * off / kSamples;
    }
    return std::sqrt(squares);
}

TEST(OneEuro, NoiseIsNotFollowedAhead) {
    OneEuroParams believing;
    believing.restSpeed = 0;
    std::printf("1 mm of noise: %.2f mm, all believed %.2f mm\n", 1e3 * noiseAhead({}),
                1e3 * noiseAhead(believing));
    EXPECT_LT(noiseAhead({}), 0.0015); // measured 1.34 mm
    EXPECT_GT(noiseAhead(believing), 0.002);
}

TEST(OneEuro, WhatIsNotLaterChangesNothing) {
    OneEuro filter(OneEuroParams{}, atSeconds(1), {0.1, 0, 0.6});
    filter.add(atSeconds(1), {5, 5, 5});
    filter.add(atSeconds(0.5), {5, 5, 5});
    EXPECT_EQ(filter.at(atSeconds(2)), (glm::dvec3{0.1, 0, 0.6}));
}

} // namespace
} // namespace autostereo::test

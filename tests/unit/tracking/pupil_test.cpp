// Irises drawn with their middle between pixels; the truth is where they were drawn.

#include "devices/tracking/pupil.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace autostereo::test {
namespace {

using devices::pupilCentre;

constexpr int kWidth = 31, kHeight = 25;

/// An iris with its pupil and a highlight in the sclera, the upper lid over `covered` of it.
struct Eye {
    glm::dvec2 middle;
    double radius = 5.6;
    double covered = 0.25;
    double noise = 4;

    [[nodiscard]] double level(const glm::dvec2& at) const {
        if (at.y < middle.y - radius + 2 * radius * covered) return 170; // skin
        if (glm::length(at - middle - glm::dvec2{0.3, -0.2} * radius) < 0.15 * radius) return 240;
        const double distance = glm::length(at - middle);
        if (distance < 0.4 * radius) return 20;
        return distance < radius ? 70 : 200;
    }
    /// Sixteen samples a pixel, each way.
    [[nodiscard]] std::vector<std::uint8_t> drawn(std::mt19937& random) const {
        constexpr int kSamples = 16;
        std::normal_distribution<double> grain(0, noise);
        std::vector<std::uint8_t> pixels;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                double sum = 0;
                for (int row = 0; row < kSamples; ++row)
                    for (int column = 0; column < kSamples; ++column)
                        sum += level({x - 0.5 + (column + 0.5) / kSamples,
                                      y - 0.5 + (row + 0.5) / kSamples});
                const double value = sum / (kSamples * kSamples) + grain(random);
                pixels.push_back(static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0)));
            }
        return pixels;
    }
};

// A 20th of the radius is 0.6 mm of an eye: 1 % of a distance by the spacing. The lid takes the
// upper edge away, which leaves the height less sure.
TEST(Pupil, IsFoundBetweenPixelsUnderALidAndAHighlight) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(13, 17), y(11, 14), covered(0, 0.3);
    double worstX = 0, worstY = 0;
    for (int i = 0; i < 40; ++i) {
        const Eye eye{{x(random), y(random)}, 5.6, covered(random)};
        const std::vector<std::uint8_t> pixels = eye.drawn(random);
        const auto found = pupilCentre({pixels, kWidth, kHeight}, 5.6);
        ASSERT_TRUE(found) << i;
        worstX = std::max(worstX, std::abs(found->x - eye.middle.x));
        worstY = std::max(worstY, std::abs(found->y - eye.middle.y));
    }
    std::printf("40 irises of 5.6 pixels: %.2f aside, %.2f up or down at most\n", worstX, worstY);
    EXPECT_LT(worstX, 5.6 / 20);
    EXPECT_LT(worstY, 5.6 / 10);
}

TEST(Pupil, IsFoundWhereTheRadiusIsAFifthOff) {
    std::mt19937 random(4);
    for (const double share : {0.8, 1.2}) {
        const Eye eye{{15.3, 12.6}, 5.6 * share};
        const std::vector<std::uint8_t> pixels = eye.drawn(random);
        const auto found = pupilCentre({pixels, kWidth, kHeight}, 5.6);
        ASSERT_TRUE(found);
        EXPECT_LT(glm::length(*found - eye.middle), 5.6 / 8) << share;
    }
}

TEST(Pupil, IsNowhereInAPictureWithoutEdgesOrRoom) {
    const std::vector<std::uint8_t> flat(static_cast<std::size_t>(kWidth * kHeight), 90);
    EXPECT_FALSE(pupilCentre({flat, kWidth, kHeight}, 5.6));
    EXPECT_FALSE(pupilCentre({flat, kWidth, kHeight}, 0));
    EXPECT_FALSE(pupilCentre({flat, 5, 4}, 5.6));
    EXPECT_FALSE(pupilCentre({{}, 0, 0}, 5.6));
}

} // namespace
} // namespace autostereo::test

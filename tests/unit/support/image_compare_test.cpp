#include "tests/support/image_compare.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>
#include <vector>

namespace autostereo::test {
namespace {

using Samples = std::vector<std::uint8_t>;

ImageView rgb(const Samples& samples, int width, int height) {
    return {.samples = samples, .width = width, .height = height, .channels = 3};
}

TEST(ImageCompare, EqualPicturesDoNotDiffer) {
    const Samples samples{0, 10, 255, 3, 4, 5};
    const auto difference = compareImages(rgb(samples, 2, 1), rgb(samples, 2, 1));
    EXPECT_EQ(difference.max, 0);
    EXPECT_EQ(difference.mean, 0.0);
    EXPECT_EQ(difference.shareAbove, 0.0);
    EXPECT_EQ(difference.psnrDb, std::numeric_limits<double>::infinity());
}

TEST(ImageCompare, FindsTheLargestDifferenceEitherWay) {
    const Samples expected(2 * 3 * 3, 100);
    Samples actual = expected;
    actual[3 * (1 * 2 + 0) + 1] = 120; // pixel (0, 1), green
    actual[3 * (2 * 2 + 1) + 2] = 60;  // pixel (1, 2), blue
    const auto difference = compareImages(rgb(actual, 2, 3), rgb(expected, 2, 3));
    EXPECT_EQ(difference.max, 40);
    EXPECT_EQ(difference.maxX, 1);
    EXPECT_EQ(difference.maxY, 2);
    EXPECT_EQ(difference.maxChannel, 2);
    EXPECT_DOUBLE_EQ(difference.mean, (20.0 + 40.0) / 18.0);
    EXPECT_DOUBLE_EQ(difference.shareAbove, 2.0 / 18.0);
    const double meanSquare = (20.0 * 20.0 + 40.0 * 40.0) / 18.0;
    EXPECT_DOUBLE_EQ(difference.psnrDb, 10.0 * std::log10(255.0 * 255.0 / meanSquare));
}

TEST(ImageCompare, ThresholdItselfIsNotAbove) {
    const Samples expected{0, 0, 0};
    const Samples actual{16, 17, 15};
    EXPECT_DOUBLE_EQ(compareImages(rgb(actual, 1, 1), rgb(expected, 1, 1), 16).shareAbove,
                     1.0 / 3.0);
}

TEST(ImageCompare, RefusesOtherShapes) {
    const Samples six(6);
    const Samples five(5);
    const ImageView gray{.samples = six, .width = 6, .height = 1, .channels = 1};
    EXPECT_THROW((void)compareImages(rgb(six, 2, 1), rgb(six, 1, 2)), std::invalid_argument);
    EXPECT_THROW((void)compareImages(rgb(six, 2, 1), gray), std::invalid_argument);
    EXPECT_THROW((void)compareImages(rgb(five, 2, 1), rgb(six, 2, 1)), std::invalid_argument);
    EXPECT_THROW((void)compareImages({}, {}), std::invalid_argument);
}

} // namespace
} // namespace autostereo::test

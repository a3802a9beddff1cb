#include "devices/kinect2/sub_image.hpp"

#include "tests/oracle/kinect2_oracle.hpp"

#include <gtest/gtest.h>

namespace autostereo::test {
namespace {

using namespace devices::kinect2;

TEST(SubImage, CompandingIsTheSensors) {
    const auto& table = companding();
    // Corners of the table that the vendor's own driver shipped.
    EXPECT_EQ(table[0], 0);
    EXPECT_EQ(table[256], 256);
    EXPECT_EQ(table[257], 258);
    EXPECT_EQ(table[384], 512);
    EXPECT_EQ(table[1023], 16320);
    EXPECT_EQ(table[1025], -1);
    EXPECT_EQ(table[2047], -16320);
    EXPECT_EQ(table[1024], kSaturated);
}

TEST(SubImage, EveryPixelOfAnyBytesAgreesWithTheOracle) {
    RawDepthFrame frame;
    std::mt19937 random(1);
    for (std::byte& byte : frame.bytes)
        byte = static_cast<std::byte>(random());
    std::array<std::int16_t, kWidth> samples{};
    for (const std::size_t subImage : {0U, 8U})
        for (int y = 0; y < kHeight; ++y) {
            unpackRow(frame.subImage(subImage), y, samples);
            for (int x = 1; x < kWidth - 1; ++x) {
                const auto expected = oracle::sampleAt(frame, subImage, x, y);
                ASSERT_EQ(samples[static_cast<std::size_t>(x)], expected.value_or(kSaturated))
                    << x << ' ' << y;
            }
        }
}

} // namespace
} // namespace autostereo::test

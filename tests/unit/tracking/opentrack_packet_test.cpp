#include "devices/tracking/opentrack_packet.hpp"
#include "tests/unit/tracking/opentrack_bytes.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>

namespace autostereo::test {
namespace {

using devices::parseOpentrack;

constexpr double kDegree = std::numbers::pi / 180;

TEST(OpentrackPacket, SixDoublesInTheirUnits) {
    const auto head = parseOpentrack(opentrackBytes({12.5, -3, 40, -15, 5, 90}));
    ASSERT_TRUE(head);
    EXPECT_DOUBLE_EQ(head->positionM.x, 0.125);
    EXPECT_DOUBLE_EQ(head->positionM.y, -0.03);
    EXPECT_DOUBLE_EQ(head->positionM.z, 0.4);
    EXPECT_DOUBLE_EQ(head->yawRad, -15 * kDegree);
    EXPECT_DOUBLE_EQ(head->pitchRad, 5 * kDegree);
    EXPECT_DOUBLE_EQ(head->rollRad, 90 * kDegree);
}

// The same bytes as Python's struct.pack('<6d', 1, -2, 0.5, 0, 0, 0).
TEST(OpentrackPacket, BytesAreLittleEndian) {
    std::vector<std::byte> bytes(48);
    bytes[6] = std::byte{0xf0};
    bytes[7] = std::byte{0x3f};
    bytes[15] = std::byte{0xc0};
    bytes[22] = std::byte{0xe0};
    bytes[23] = std::byte{0x3f};
    const auto head = parseOpentrack(bytes);
    ASSERT_TRUE(head);
    EXPECT_DOUBLE_EQ(head->positionM.x, 0.01);
    EXPECT_DOUBLE_EQ(head->positionM.y, -0.02);
    EXPECT_DOUBLE_EQ(head->positionM.z, 0.005);
}

TEST(OpentrackPacket, EveryOtherSizeIsRefused) {
    for (std::size_t size = 0; size <= 200; ++size)
        EXPECT_EQ(parseOpentrack(std::vector<std::byte>(size)).has_value(), size == 48) << size;
}

TEST(OpentrackPacket, WhatIsNoPlaceIsRefusedInEveryField) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (std::size_t field = 0; field < 6; ++field)
        for (const double wrong : {nan, -nan, infinity, -infinity, 1000.1, -1000.1, 1e300}) {
            std::array<double, 6> numbers{1, 2, 3, 4, 5, 6};
            numbers[field] = wrong;
            EXPECT_FALSE(parseOpentrack(opentrackBytes(numbers))) << field << ' ' << wrong;
        }
}

TEST(OpentrackPacket, AnyBytesGiveAPlaceOrNothing) {
    std::mt19937_64 random(7);
    int good = 0;
    for (int i = 0; i < 200'000; ++i) {
        std::array<double, 6> numbers{};
        for (double& number : numbers)
            number = std::bit_cast<double>(random());
        const auto head = parseOpentrack(opentrackBytes(numbers));
        if (!head) continue;
        ++good;
        for (const double number : {head->positionM.x, head->positionM.y, head->positionM.z})
            EXPECT_LE(std::abs(number), 10);
        for (const double angle : {head->yawRad, head->pitchRad, head->rollRad})
            EXPECT_LE(std::abs(angle), 2 * std::numbers::pi + 1e-12);
    }
    EXPECT_GT(good, 100); // half of all doubles are small
}

} // namespace
} // namespace autostereo::test

#include "calib/depth_frame_header.hpp"

#include <gtest/gtest.h>

namespace autostereo::calib {
namespace {

std::vector<std::uint8_t> message(std::uint8_t contentType) {
    return {0xF1, contentType, 0x40, 0x80, 0, 0};
}

// Long division of the message followed by 32 zero bits, done by hand elsewhere.
TEST(DepthFrameHeader, CrcVectors) {
    EXPECT_EQ(depthFrameCrc(message(2)), 0x1F3A7B38U);
    EXPECT_EQ(depthFrameCrc(message(1)), 0xC42DD3AFU);
    EXPECT_EQ(depthFrameCrc(message(3)), 0x56371CB5U);
    EXPECT_EQ(depthFrameCrc(message(0)), 0x8D20B422U);
    EXPECT_EQ(depthFrameCrc({}), 0U);
}

TEST(DepthFrameHeader, BytesInOrder) {
    const std::array<std::uint8_t, 10> expected{0xF1, 2, 64, 128, 0, 0, 0x1F, 0x3A, 0x7B, 0x38};
    EXPECT_EQ(depthFrameHeader({}), expected);
    DepthFrame frame;
    frame.contentType = 3;
    EXPECT_EQ(depthFrameHeader(frame).at(6), 0x56);
}

/// Bit b (7 first) of byte n at x = 2 (7 - b) + 16 n.
TEST(DepthFrameHeader, BitPositionsOnTheTopRow) {
    const auto row = depthFrameHeaderRow({});
    ASSERT_EQ(row.size(), 256U);
    std::array<std::uint8_t, 10> read{};
    for (std::size_t n = 0; n < read.size(); ++n)
        for (std::size_t b = 0; b < 8; ++b)
            if (row[2 * (7 - b) + 16 * n] == 255) read.at(n) |= static_cast<std::uint8_t>(1U << b);
    EXPECT_EQ(read, depthFrameHeader({}));
    for (std::size_t x = 1; x < row.size(); x += 2)
        EXPECT_EQ(row[x], 0) << x;
    for (std::size_t x = 160; x < row.size(); ++x)
        EXPECT_EQ(row[x], 0) << x;
}

} // namespace
} // namespace autostereo::calib

#include "devices/frame_pool.hpp"
#include "devices/v4l2/unpack.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace autostereo {
namespace {

using devices::Frame;
using devices::FramePool;
using devices::PixelFormat;
using devices::v4l2::bufferBytes;
using devices::v4l2::unpack;

/// Each byte says in which row and column of its plane it is; padding is 0xee.
std::vector<std::byte> padded(int rows, int rowBytes, int stride) {
    std::vector<std::byte> bytes(static_cast<std::size_t>(rows * stride), std::byte{0xee});
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < rowBytes; ++x)
            bytes[static_cast<std::size_t>(y * stride + x)] = static_cast<std::byte>(16 * y + x);
    return bytes;
}

TEST(Unpack, TakesThePaddingOutOfRows) {
    FramePool pool(2);
    for (const int stride : {8, 13}) {
        Frame frame = *pool.acquire({PixelFormat::Yuyv, 4, 3});
        ASSERT_TRUE(unpack(padded(3, 8, stride), static_cast<std::size_t>(stride), frame));
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 8; ++x)
                EXPECT_EQ(frame.pixels()[static_cast<std::size_t>(8 * y + x)],
                          static_cast<std::byte>(16 * y + x));
    }
    // NV12: two rows of luma, one of chroma, all of one length.
    Frame frame = *pool.acquire({PixelFormat::Nv12, 4, 2});
    ASSERT_TRUE(unpack(padded(3, 4, 6), 6, frame));
    EXPECT_EQ(frame.pixels()[7], std::byte{16 + 3});
    EXPECT_EQ(frame.pixels()[8], std::byte{32});
    EXPECT_EQ(frame.pixels()[11], std::byte{32 + 3});
}

TEST(Unpack, TheLastRowNeedsNoPadding) {
    FramePool pool(1);
    std::vector<std::byte> bytes = padded(3, 8, 13);
    bytes.resize(bufferBytes(PixelFormat::Yuyv, 4, 3, 13));
    EXPECT_EQ(bytes.size(), 2U * 13 + 8);
    Frame frame = *pool.acquire({PixelFormat::Yuyv, 4, 3});
    EXPECT_TRUE(unpack(bytes, 13, frame));
    bytes.pop_back();
    EXPECT_FALSE(unpack(bytes, 13, frame));
}

TEST(Unpack, SizesThatCannotBeAreRefused) {
    FramePool pool(1);
    Frame frame = *pool.acquire({PixelFormat::Yuyv, 4, 3});
    EXPECT_FALSE(unpack(padded(3, 8, 13), 7, frame)) << "rows overlap";
    EXPECT_FALSE(unpack(padded(3, 8, 13), std::size_t{1} << 40U, frame));
    EXPECT_FALSE(unpack({}, 8, frame));
    EXPECT_EQ(bufferBytes(PixelFormat::Yuyv, 3, 3, 100), 0U);
    EXPECT_EQ(bufferBytes(PixelFormat::Grey8, 0, 3, 100), 0U);
}

} // namespace
} // namespace autostereo

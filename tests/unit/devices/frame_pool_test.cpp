#include "devices/frame_pool.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

using namespace autostereo::devices;

namespace {

FrameMetadata depthOf(int width, int height, bool amplitude = false) {
    FrameMetadata metadata;
    metadata.format = PixelFormat::Depth16;
    metadata.width = width;
    metadata.height = height;
    metadata.hasAmplitude = amplitude;
    return metadata;
}

TEST(FramePool, LeasesEachSlotOnceAndTakesItBack) {
    FramePool pool(2);
    auto first = pool.acquire(depthOf(4, 4));
    auto second = pool.acquire(depthOf(4, 4));
    ASSERT_TRUE(first && second);
    EXPECT_NE(first->pixels().data(), second->pixels().data());
    EXPECT_EQ(pool.leased(), 2U);
    EXPECT_FALSE(pool.acquire(depthOf(4, 4)));
    first.reset();
    EXPECT_EQ(pool.leased(), 1U);
    EXPECT_TRUE(pool.acquire(depthOf(4, 4)));
}

TEST(FramePool, HasRoomForEveryPlaneAndKeepsItsStorage) {
    FramePool pool(1);
    const std::byte* big = nullptr;
    {
        auto frame = pool.acquire(depthOf(640, 576, true));
        ASSERT_TRUE(frame);
        frame->amplitude().back() = 7; // AddressSanitizer sees a slot that is too small
        EXPECT_EQ(frame->depth().size(), 640U * 576U);
        EXPECT_EQ(frame->amplitude().data(), frame->depth().data() + frame->depth().size());
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(frame->pixels().data()) %
                      alignof(std::max_align_t),
                  0U);
        big = frame->pixels().data();
    }
    auto small = pool.acquire(depthOf(8, 8));
    ASSERT_TRUE(small);
    EXPECT_EQ(small->pixels().data(), big);
    EXPECT_EQ(small->pixels().size(), 8U * 8U * 2U);
}

TEST(FramePool, LongerEncodedPicturesNeedNoFreshMemory) {
    FramePool pool(1);
    FrameMetadata metadata = depthOf(1920, 1080);
    const std::byte* first = nullptr;
    for (const std::size_t encodedBytes : {200'000U, 210'000U, 300'000U}) {
        metadata.encodedBytes = encodedBytes;
        auto frame = pool.acquire(metadata);
        ASSERT_TRUE(frame);
        frame->encoded().back() = std::byte{1};
        if (first == nullptr) first = frame->pixels().data();
        EXPECT_EQ(frame->pixels().data(), first);
    }
}

TEST(FramePool, FramesOutliveIt) {
    std::optional<Frame> frame;
    {
        FramePool pool(1);
        frame = pool.acquire(depthOf(16, 16));
    }
    ASSERT_TRUE(frame);
    frame->depth().back() = 1234;
    EXPECT_EQ(frame->depth().back(), 1234);
}

TEST(FramePool, MovingAFrameMovesItsLease) {
    FramePool pool(2);
    Frame kept;
    {
        auto frame = pool.acquire(depthOf(4, 4));
        ASSERT_TRUE(frame);
        kept = std::move(*frame);
    }
    EXPECT_EQ(pool.leased(), 1U);
    kept = Frame{};
    EXPECT_EQ(pool.leased(), 0U);
}

} // namespace

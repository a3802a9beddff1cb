#include "devices/frame_queue.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <random>

using autostereo::devices::FrameQueue;

namespace {

TEST(FrameQueue, GivesElementsInOrder) {
    FrameQueue<int, 3> queue;
    EXPECT_FALSE(queue.take());
    queue.push(1);
    queue.push(2);
    EXPECT_EQ(queue.size(), 2U);
    EXPECT_EQ(queue.take(), 1);
    queue.push(3);
    EXPECT_EQ(queue.take(), 2);
    EXPECT_EQ(queue.take(), 3);
    EXPECT_FALSE(queue.take());
}

TEST(FrameQueue, DropsTheOldestWhenFull) {
    FrameQueue<int, 3> queue;
    for (int i = 0; i < 10; ++i)
        queue.push(i);
    EXPECT_EQ(queue.dropped(), 7U);
    EXPECT_EQ(queue.size(), 3U);
    EXPECT_EQ(queue.take(), 7);
    EXPECT_EQ(queue.take(), 8);
    queue.push(10);
    queue.push(11);
    queue.push(12); // 9 goes
    EXPECT_EQ(queue.take(), 10);
    EXPECT_EQ(queue.dropped(), 8U);
}

TEST(FrameQueue, DestroysWhatItDropsAtOnceAndWhatIsLeftAtTheEnd) {
    const auto token = std::make_shared<int>(0);
    {
        FrameQueue<std::shared_ptr<int>, 2> queue;
        for (int i = 0; i < 5; ++i)
            queue.push(token);
        EXPECT_EQ(token.use_count(), 1 + 2);
        EXPECT_TRUE(queue.take());
        EXPECT_EQ(token.use_count(), 1 + 1);
    }
    EXPECT_EQ(token.use_count(), 1);
}

TEST(FrameQueue, HoldsOneElementWhenAskedTo) {
    FrameQueue<int, 1> queue;
    queue.push(1);
    queue.push(2);
    EXPECT_EQ(queue.take(), 2);
    EXPECT_FALSE(queue.take());
}

TEST(FrameQueue, BalancesInAnyOrderOfCalls) {
    FrameQueue<int, 4> queue;
    std::mt19937 random(5);
    int last = -1;
    for (int i = 0; i < 100'000; ++i) {
        if (random() % 2 == 0) {
            queue.push(i);
        } else if (const auto value = queue.take()) {
            ASSERT_GT(*value, last);
            last = *value;
        }
        ASSERT_EQ(queue.pushed(), queue.taken() + queue.dropped() + queue.size());
    }
    EXPECT_GT(queue.dropped(), 1000U);
    EXPECT_GT(queue.taken(), 1000U);
}

} // namespace

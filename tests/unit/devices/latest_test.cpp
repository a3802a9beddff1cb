#include "devices/latest.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace autostereo {
namespace {

using devices::Latest;
using namespace std::chrono_literals;

devices::TimePoint in(std::chrono::milliseconds time) {
    return std::chrono::steady_clock::now() + time;
}

TEST(Latest, TheNewestWinsAndWhatWasNotTakenIsCounted) {
    Latest<std::vector<int>> latest;
    std::vector<int> mine;
    EXPECT_FALSE(latest.take(mine, in(0ms)));
    for (int i = 1; i <= 3; ++i) {
        std::vector<int> value{i};
        latest.put(value);
    }
    ASSERT_TRUE(latest.take(mine, in(0ms)));
    EXPECT_EQ(mine, std::vector{3});
    EXPECT_FALSE(latest.take(mine, in(0ms))) << "once only";
    EXPECT_EQ(mine, std::vector{3});
    EXPECT_EQ(latest.overwritten(), 2U);
}

TEST(Latest, MemoryGoesRoundInACircle) {
    Latest<std::vector<int>> latest;
    std::vector<int> writer(100), reader(100);
    for (int i = 0; i < 10; ++i) {
        writer.assign(100, i);
        latest.put(writer);
        ASSERT_TRUE(latest.take(reader, in(0ms)));
        ASSERT_EQ(reader, std::vector<int>(100, i));
    }
    EXPECT_EQ(writer.capacity(), 100U);
}

TEST(Latest, WakesWhoeverWaits) {
    Latest<int> latest;
    int value = 0;
    std::jthread writer([&] {
        std::this_thread::sleep_for(20ms);
        int seven = 7;
        latest.put(seven);
        std::this_thread::sleep_for(20ms);
        latest.close();
    });
    ASSERT_TRUE(latest.take(value, in(10s)));
    EXPECT_EQ(value, 7);
    const auto started = std::chrono::steady_clock::now();
    EXPECT_FALSE(latest.take(value, in(10s)));
    EXPECT_LT(std::chrono::steady_clock::now() - started, 5s);
}

} // namespace
} // namespace autostereo

#include "daemon/http/rate_limit.hpp"

#include <gtest/gtest.h>

namespace autostereo::daemon {
namespace {

using devices::TimePoint;
using std::chrono::milliseconds;

TEST(RateLimit, LetsSoManyThroughASecond) {
    RateLimit limit(5);
    int passed = 0;
    for (int ms = 0; ms < 10'000; ++ms)
        passed += static_cast<int>(limit.pass(TimePoint(milliseconds(ms))));
    EXPECT_NEAR(passed, 5 + 50, 1) << "a second's worth at once, then so many each second";
}

TEST(RateLimit, RestSavesNoMoreThanASecondsWorth) {
    RateLimit limit(5);
    (void)limit.pass(TimePoint());
    int passed = 0;
    for (int i = 0; i < 100; ++i)
        passed += static_cast<int>(limit.pass(TimePoint(std::chrono::hours(1))));
    EXPECT_EQ(passed, 5);
}

} // namespace
} // namespace autostereo::daemon

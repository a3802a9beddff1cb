#include "daemon/control/time_share.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace autostereo::daemon {
namespace {

using devices::TimePoint;
using std::chrono::milliseconds;

// Somebody who asks all the time and needs 7 ms each.
TEST(TimeShare, TakesNoMoreThanItsShare) {
    TimeShare share(4);
    EXPECT_TRUE(share.isFree(TimePoint(milliseconds(1))));
    int taken = 0;
    for (int ms = 1; ms < 10'000;) {
        if (!share.isFree(TimePoint(milliseconds(ms)))) {
            ++ms;
            continue;
        }
        share.used(TimePoint(milliseconds(ms)), TimePoint(milliseconds(ms + 7)));
        ms += 7;
        taken += 7;
    }
    EXPECT_NEAR(taken, 10'000 / 5, 7);
}

} // namespace
} // namespace autostereo::daemon

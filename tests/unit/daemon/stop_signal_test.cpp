#include "daemon/stop_signal.hpp"

#include <gtest/gtest.h>

#include <csignal>

using autostereo::daemon::StopSignal;

namespace {

TEST(StopSignal, IsSetByEitherSignal) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const StopSignal stop;
        EXPECT_FALSE(stop.requested());
        std::raise(signal);
        EXPECT_TRUE(stop.requested());
    }
}

TEST(StopSignalDeathTest, ASecondSignalHasItsDefaultAction) {
    for (const int second : {SIGINT, SIGTERM})
        EXPECT_EXIT(
            {
                const StopSignal stop;
                std::raise(SIGINT);
                if (stop.requested()) std::raise(second);
            },
            testing::KilledBySignal(second), "");
}

TEST(StopSignal, RestoresWhatWasThere) {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    struct sigaction original {};
    sigaction(SIGTERM, &ignore, &original);
    {
        const StopSignal stop;
        std::raise(SIGTERM);
    }
    struct sigaction after {};
    sigaction(SIGTERM, &original, &after);
    EXPECT_EQ(after.sa_handler, SIG_IGN);
}

} // namespace

#include "tests/replay/notify_socket.hpp"
#include "tests/replay/program.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace autostereo::test {
namespace {

using std::chrono::milliseconds;

struct EndedBy : testing::TestWithParam<int> {
    /// A run without end that says on `socket` when it has begun.
    [[nodiscard]] ProgramCall endless(const NotifySocket& socket) const {
        auto call =
            calling({"run", "--input", kSmallPerson, "--display", smallDisplay(folder), "--output",
                     "offscreen", "--frames", "1000000", "--report", folder / "report.json"});
        call.environment.push_back("NOTIFY_SOCKET=" + socket.path());
        return call;
    }
    TempFolder folder;
};

constexpr milliseconds kPatience{20'000 * kSlower};

TEST_P(EndedBy, WithinASecondWithAReport) {
    NotifySocket socket(folder / "notify");
    RunningProgram program(endless(socket));
    ASSERT_TRUE(socket.waitFor("READY=1", kPatience));
    std::this_thread::sleep_for(milliseconds(300)); // frames are on their way

    const auto asked = std::chrono::steady_clock::now();
    program.signal(GetParam());
    const ProgramResult result = program.wait();
    EXPECT_LT(std::chrono::steady_clock::now() - asked, milliseconds(1000 * kSlower));
    EXPECT_TRUE(succeeded(result));
    EXPECT_TRUE(balanced(readReport(folder / "report.json")));
    EXPECT_TRUE(socket.waitFor("STOPPING=1", milliseconds(0)));
}

INSTANTIATE_TEST_SUITE_P(Signals, EndedBy, testing::Values(SIGINT, SIGTERM),
                         [](const auto& tested) {
                             return tested.param == SIGINT ? "Int" : "Term";
                         });

using Notified = EndedBy;

TEST_F(Notified, TheServiceManagerHearsThatWeAreAlive) {
    NotifySocket socket(folder / "notify");
    auto call = endless(socket);
    call.environment.push_back("WATCHDOG_USEC=200000");
    RunningProgram program(call);
    ASSERT_TRUE(socket.waitFor("READY=1", kPatience));
    EXPECT_TRUE(socket.waitFor("WATCHDOG=1", kPatience));
    EXPECT_TRUE(socket.waitFor("WATCHDOG=1", kPatience)) << "once is not enough";
    program.signal(SIGTERM);
    EXPECT_TRUE(socket.waitFor("STOPPING=1", kPatience));
    EXPECT_TRUE(succeeded(program.wait()));
}

} // namespace
} // namespace autostereo::test

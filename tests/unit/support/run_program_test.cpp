#include "tests/support/run_program.hpp"

#include <csignal>
#include <cstdlib>
#include <gtest/gtest.h>
#include <system_error>

namespace autostereo::test {
namespace {

using std::chrono::milliseconds;

ProgramCall shell(const std::string& script) {
    ProgramCall call;
    call.program = "/bin/sh";
    call.arguments = {"-c", script};
    call.limit = milliseconds(20'000);
    return call;
}

TEST(RunProgram, KeepsOutputAndExitCodeApart) {
    const auto result = runProgram(shell("echo seen; echo wrong >&2; exit 3"));
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_EQ(result.out, "seen\n");
    EXPECT_EQ(result.err, "wrong\n");
    EXPECT_FALSE(result.timedOut);
}

TEST(RunProgram, SwallowsMoreThanAPipeHolds) {
    const auto result = runProgram(shell("yes 1234567 | head -n 100000"));
    EXPECT_EQ(result.out.size(), 800'000U);
}

TEST(RunProgram, GivesEmptyInputFolderAndEnvironment) {
    ASSERT_EQ(setenv("RUN_PROGRAM_TEST", "ours", 1), 0);
    auto call = shell("cat; pwd; echo $RUN_PROGRAM_TEST; env | grep -c ^RUN_PROGRAM_TEST=");
    call.workingFolder = "/";
    EXPECT_EQ(runProgram(call).out, "/\nours\n1\n");
    call.environment = {"RUN_PROGRAM_TEST=theirs"};
    EXPECT_EQ(runProgram(call).out, "/\ntheirs\n1\n");
}

TEST(RunProgram, InterruptsWithTheSignalAskedFor) {
    auto call = shell("trap 'echo stopped; exit 7' TERM; while :; do sleep 0.01; done");
    call.interruption = {SIGTERM, milliseconds(200)};
    const auto result = runProgram(call);
    EXPECT_EQ(result.exitCode, 7);
    EXPECT_EQ(result.out, "stopped\n");
    EXPECT_GE(result.wall, milliseconds(200));
    EXPECT_FALSE(result.timedOut);
}

TEST(RunProgram, ReportsTheSignalThatEndedIt) {
    EXPECT_EQ(runProgram(shell("kill -SEGV $$")).exitCode, 128 + SIGSEGV);
}

TEST(RunProgram, KillsWhatRunsOverTheLimitWithItsChildren) {
    auto call = shell("sleep 60 & echo $!; trap '' TERM; wait");
    call.limit = milliseconds(300);
    const auto result = runProgram(call);
    EXPECT_TRUE(result.timedOut);
    EXPECT_EQ(result.exitCode, 128 + SIGKILL);
    EXPECT_LT(result.wall, milliseconds(10'000));
    const std::string grandchild = result.out.substr(0, result.out.find('\n'));
    // Gone, or a zombie that its new parent has not collected yet; dying takes it a moment.
    const auto look = runProgram(shell("state=/proc/" + grandchild +
                                       "/status; for i in 1 2 3 4 5 6 7 8 9 10; do "
                                       "grep -qs '^State:[^Z]*$' $state || exit 0; sleep 0.1; "
                                       "done; echo alive"));
    EXPECT_EQ(look.out, "");
}

TEST(RunProgram, ThrowsWhenThereIsNoSuchProgram) {
    ProgramCall call;
    call.program = "/nonexistent/program";
    EXPECT_THROW((void)runProgram(call), std::system_error);
}

} // namespace
} // namespace autostereo::test

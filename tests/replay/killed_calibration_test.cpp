// A calibration that is killed at any moment leaves a whole file: the one before or the new one.

#include "tests/replay/program.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <thread>
#include <tuple>

#include <sys/wait.h>
#include <unistd.h>

namespace autostereo::test {
namespace {

std::string textOf(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Starts the program, kills it after so long; true where it had ended by itself.
bool killedAfter(const ProgramCall& call, std::chrono::microseconds wait) {
    std::vector<char*> arguments{const_cast<char*>(call.program.c_str())};
    for (const std::string& argument : call.arguments)
        arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        static_cast<void>(::close(STDOUT_FILENO));
        ::execv(arguments[0], arguments.data());
        ::_exit(127);
    }
    std::this_thread::sleep_for(wait);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Listed points of a camera `shift` pixels aside at 1 m.
std::string pointsFor(double shift) {
    std::string text;
    for (const auto& [x, y, metres] : {std::tuple{100, 100, 1},
                                       {540, 100, 2},
                                       {100, 400, 4},
                                       {540, 400, 1},
                                       {320, 240, 2},
                                       {200, 300, 4}})
        text += std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(1000 * metres) +
                ' ' + std::to_string(x - shift / metres) + ' ' + std::to_string(y) + '\n';
    return text;
}

TEST(KilledCalibration, LeavesAWholeFile) {
    const TempFolder folder;
    const std::string rig = twoCameras(folder);
    const std::vector<std::string> points{folder.file("a.txt", pointsFor(20)),
                                          folder.file("b.txt", pointsFor(30))};
    const std::string output = folder / "rig.toml";
    const auto calibration = [&](std::size_t which) {
        return calling(
            {"calibrate", "rig", "--pairs", points.at(which), "--rig", rig, "--output", output});
    };
    std::set<std::string> whole;
    const auto before = std::chrono::steady_clock::now();
    for (const std::size_t which : {0U, 1U}) {
        ASSERT_TRUE(succeeded(runProgram(calibration(which))));
        whole.insert(textOf(output));
    }
    ASSERT_EQ(whole.size(), 2U);
    const auto one = (std::chrono::steady_clock::now() - before) / 2;
    const auto longest = std::chrono::duration_cast<std::chrono::microseconds>(one * 5 / 4).count();

    std::mt19937 random(1);
    std::uniform_int_distribution<long> wait(0, longest);
    int ended = 0, killed = 0;
    for (std::size_t run = 0; run < 200; ++run) {
        const std::chrono::microseconds moment(wait(random));
        ++(killedAfter(calibration(run % 2), moment) ? ended : killed);
        EXPECT_TRUE(whole.contains(textOf(output))) << "run " << run << ": " << textOf(output);
        EXPECT_TRUE(whole.contains(textOf(output + ".old"))) << "run " << run;
    }
    std::printf("%d killed, %d ended before\n", killed, ended);
    EXPECT_GT(killed, 20);
}

} // namespace
} // namespace autostereo::test

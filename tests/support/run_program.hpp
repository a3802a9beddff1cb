#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace autostereo::test {

/// What to start, and when to interfere.
struct ProgramCall {
    /// A signal sent to the program some time after its start.
    struct Interruption {
        int signal;
        std::chrono::milliseconds after;
    };

    std::filesystem::path program;
    std::vector<std::string> arguments;
    std::vector<std::string> environment;    ///< NAME=value, added to our own or in their place
    std::filesystem::path workingFolder;     ///< empty: ours
    std::chrono::milliseconds limit{60'000}; ///< then the program and its children are killed
    std::optional<Interruption> interruption;
};

struct ProgramResult {
    int exitCode = 0; ///< 128 + number when a signal ended it, as in a shell
    bool timedOut = false;
    std::string out; ///< all of stdout
    std::string err;
    std::chrono::milliseconds wall{0};
};

/// Runs a program to its end, with empty stdin; blocks. Its output goes to files in memory, so it
/// never waits for a reader. Throws std::system_error when it cannot be started. Reentrant.
[[nodiscard]] ProgramResult runProgram(const ProgramCall& call);

} // namespace autostereo::test

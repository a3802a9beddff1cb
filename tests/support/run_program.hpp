#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
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

/// A program at work, with empty stdin, in a process group of its own. Its output goes to files in
/// memory, so it never waits for a reader. Destruction kills what still runs. Throws
/// std::system_error when it cannot be started. Thread-bound.
class RunningProgram {
  public:
    explicit RunningProgram(const ProgramCall& call);
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    /// What it has written so far.
    [[nodiscard]] std::string out() const;
    [[nodiscard]] std::string err() const;
    [[nodiscard]] bool running();
    void signal(int number);
    /// Blocks until it ends; interrupts and kills when the call says so, counted from the start.
    [[nodiscard]] ProgramResult wait();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Runs a program to its end; blocks. Reentrant.
[[nodiscard]] ProgramResult runProgram(const ProgramCall& call);

} // namespace autostereo::test

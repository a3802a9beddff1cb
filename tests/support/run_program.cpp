#include "tests/support/run_program.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <spawn.h>
#include <string_view>
#include <sys/mman.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace autostereo::test {

namespace {

using Milliseconds = std::chrono::milliseconds;

void check(int error, const std::string& what) {
    if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

/// An anonymous file in memory that the program writes and we read at its end.
class MemoryFile {
  public:
    MemoryFile() : fd_(memfd_create("output", MFD_CLOEXEC)) {
        check(fd_ < 0 ? errno : 0, "memfd_create");
    }
    ~MemoryFile() { close(fd_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] int fd() const { return fd_; }

    [[nodiscard]] std::string text() const {
        std::string all;
        char part[4096];
        for (ssize_t n = 0;
             (n = pread(fd_, part, sizeof part, static_cast<off_t>(all.size()))) > 0;)
            all.append(part, static_cast<std::size_t>(n));
        return all;
    }

  private:
    int fd_;
};

/// What the child does between fork and exec: its files, its folder, a process group of its own.
class SpawnSetup {
  public:
    SpawnSetup(const MemoryFile& out, const MemoryFile& err, const std::string& folder) {
        posix_spawn_file_actions_init(&files_);
        posix_spawnattr_init(&attributes_);
        posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&files_, out.fd(), STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&files_, err.fd(), STDERR_FILENO);
        if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&files_, folder.c_str());
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    }
    ~SpawnSetup() {
        posix_spawnattr_destroy(&attributes_);
        posix_spawn_file_actions_destroy(&files_);
    }
    SpawnSetup(const SpawnSetup&) = delete;
    SpawnSetup& operator=(const SpawnSetup&) = delete;

    [[nodiscard]] pid_t spawn(char* const* arguments, char* const* environment) const {
        pid_t child = 0;
        check(posix_spawn(&child, arguments[0], &files_, &attributes_, arguments, environment),
              arguments[0]);
        return child;
    }

  private:
    posix_spawn_file_actions_t files_{};
    posix_spawnattr_t attributes_{};
};

/// The null-terminated list that exec wants; borrows the strings.
std::vector<char*> pointersTo(std::vector<std::string>& strings) {
    std::vector<char*> pointers;
    pointers.reserve(strings.size() + 1);
    for (auto& text : strings)
        pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// Our environment with the call's variables in place of ours of the same name.
std::vector<std::string> environmentOf(const ProgramCall& call) {
    std::vector<std::string> environment = call.environment;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string_view own = *entry;
        const auto sameName = [name = own.substr(0, own.find('=') + 1)](const std::string& given) {
            return given.starts_with(name);
        };
        if (std::ranges::none_of(call.environment, sameName)) environment.emplace_back(own);
    }
    return environment;
}

int exitCodeOf(int status) {
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

} // namespace

struct RunningProgram::State {
    explicit State(const ProgramCall& called) : call(called) {
        std::vector<std::string> arguments{call.program};
        arguments.insert(arguments.end(), call.arguments.begin(), call.arguments.end());
        std::vector<std::string> environment = environmentOf(call);
        const SpawnSetup setup(out, err, call.workingFolder);
        child = setup.spawn(pointersTo(arguments).data(), pointersTo(environment).data());
    }

    /// Once it has ended its number may be another program's: no signal goes there.
    bool running() {
        if (ended) return false;
        const pid_t found = waitpid(child, &status, WNOHANG);
        check(found < 0 ? errno : 0, "waitpid");
        ended = found != 0;
        return !ended;
    }

    ProgramCall call;
    MemoryFile out;
    MemoryFile err;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    pid_t child = 0;
    int status = 0;
    bool ended = false;
};

RunningProgram::RunningProgram(const ProgramCall& call) : state_(std::make_unique<State>(call)) {}

RunningProgram::~RunningProgram() {
    if (state_->ended) return;
    kill(-state_->child, SIGKILL);
    waitpid(state_->child, &state_->status, 0);
}

std::string RunningProgram::out() const { return state_->out.text(); }
std::string RunningProgram::err() const { return state_->err.text(); }
bool RunningProgram::running() { return state_->running(); }

void RunningProgram::signal(int number) {
    if (running()) kill(state_->child, number);
}

ProgramResult RunningProgram::wait() {
    const ProgramCall& call = state_->call;
    const auto age = [&] {
        return duration_cast<Milliseconds>(std::chrono::steady_clock::now() - state_->start);
    };
    ProgramResult result;
    bool interrupted = false;
    while (state_->running()) {
        if (call.interruption && !interrupted && age() >= call.interruption->after) {
            kill(state_->child, call.interruption->signal);
            interrupted = true;
        }
        if (age() >= call.limit && !result.timedOut) {
            kill(-state_->child, SIGKILL);
            result.timedOut = true;
        }
        std::this_thread::sleep_for(Milliseconds(1));
    }
    result.wall = age();
    result.exitCode = exitCodeOf(state_->status);
    result.out = state_->out.text();
    result.err = state_->err.text();
    return result;
}

ProgramResult runProgram(const ProgramCall& call) { return RunningProgram(call).wait(); }

} // namespace autostereo::test

#pragma once

#include <csignal>

#include <array>

namespace autostereo::daemon {

/// SIGINT and SIGTERM ask the program to end: the first sets a flag, and from then on both have
/// their default action, so that a second one ends a program that hangs. Destruction restores what
/// was there before. Waits are not cut short (SA_RESTART); ask at least every 100 ms. One object at
/// a time; `requested` is thread-safe.
class StopSignal {
  public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    [[nodiscard]] bool requested() const noexcept;

  private:
    static constexpr std::array<int, 2> kSignals{SIGINT, SIGTERM};
    static void onSignal(int signal);

    std::array<struct sigaction, kSignals.size()> before_{};
};

} // namespace autostereo::daemon

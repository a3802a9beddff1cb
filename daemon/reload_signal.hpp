#pragma once

#include <csignal>

namespace autostereo::daemon {

/// SIGHUP asks the program to read its configuration again. Destruction restores what was there
/// before. One object at a time; thread-bound.
class ReloadSignal {
  public:
    ReloadSignal();
    ~ReloadSignal();
    ReloadSignal(const ReloadSignal&) = delete;
    ReloadSignal& operator=(const ReloadSignal&) = delete;

    /// Whether it came since the last call.
    [[nodiscard]] bool take() const noexcept;

  private:
    struct sigaction before_ {};
};

} // namespace autostereo::daemon

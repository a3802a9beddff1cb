#pragma once

#include "devices/unique_fd.hpp"

#include <chrono>
#include <string>

namespace autostereo::test {

/// The service manager's side of NOTIFY_SOCKET. Throws std::system_error. Thread-bound.
class NotifySocket {
  public:
    explicit NotifySocket(std::string path);

    [[nodiscard]] const std::string& path() const { return path_; }
    /// Reads messages until `message` comes; false when it doesn't within `limit`.
    [[nodiscard]] bool waitFor(const std::string& message, std::chrono::milliseconds limit);

  private:
    std::string path_;
    devices::UniqueFd socket_;
};

} // namespace autostereo::test

#pragma once

#include "daemon/control/control_request.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace autostereo::daemon {

/// What a running program answered: the JSON line, and the bytes that it announced.
struct ControlAnswer {
    std::string line;
    std::vector<std::uint8_t> bytes;
};

/// Asks over a connected socket (control_socket.hpp) and waits for the answer, as long as the
/// socket's time-outs allow. Throws std::runtime_error where none comes, or none that can be read.
[[nodiscard]] ControlAnswer ask(int socket, const ControlRequest& request);

} // namespace autostereo::daemon

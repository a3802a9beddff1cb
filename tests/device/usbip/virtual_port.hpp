#pragma once

#include "devices/unique_fd.hpp"
#include "tests/device/usbip/plug.hpp"

namespace autostereo::test::usbip {

/// A free port of the kernel's virtual host controller with a socket to it: the near end.
struct AttachedPort {
    int number = -1;
    devices::UniqueFd socket;
};

[[nodiscard]] bool hasVirtualPorts();
/// Throws std::runtime_error with what was tried.
[[nodiscard]] AttachedPort attachToPort(Speed speed);
[[nodiscard]] bool isFree(int port);

} // namespace autostereo::test::usbip

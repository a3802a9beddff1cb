#include "tests/device/usbip/virtual_port.hpp"

#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <sys/socket.h>

namespace autostereo::test::usbip {

namespace {

const std::string kController = "/sys/devices/platform/vhci_hcd.0/";

struct PortState {
    std::string hub; ///< hs or ss
    int number = -1;
    bool free = false;
};

/// Lines `hub port sta spd dev sockfd local_busid` below a heading.
template<class Wanted>
std::optional<PortState> findPort(const Wanted& wanted) {
    constexpr int kNoDevice = 4;
    std::ifstream status(kController + "status");
    for (std::string line; std::getline(status, line);) {
        std::istringstream fields(line);
        PortState port;
        int state = 0;
        if (!(fields >> port.hub >> port.number >> state)) continue;
        port.free = state == kNoDevice;
        if (wanted(port)) return port;
    }
    return std::nullopt;
}

/// So that a frame of a depth camera fits: the kernel's side must not wait for ours.
void enlargeBuffers(int socket) {
    const int bytes = 8 << 20;
    setsockopt(socket, SOL_SOCKET, SO_SNDBUFFORCE, &bytes, sizeof bytes);
    setsockopt(socket, SOL_SOCKET, SO_RCVBUFFORCE, &bytes, sizeof bytes);
}

} // namespace

bool hasVirtualPorts() { return std::ifstream(kController + "status").good(); }

bool isFree(int port) {
    return findPort([&](const PortState& one) { return one.number == port && one.free; })
        .has_value();
}

AttachedPort attachToPort(Speed speed) {
    const char* const hub = speed == Speed::Super ? "ss" : "hs";
    const auto port = findPort([&](const PortState& one) { return one.free && one.hub == hub; });
    if (!port)
        throw std::runtime_error("USB/IP: no free " + std::string(hub) + " port in " + kController +
                                 "status (kernel without vhci_hcd?)");
    int ends[2] = {-1, -1};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw std::runtime_error(std::string("USB/IP: socketpair: ") + std::strerror(errno));
    AttachedPort attached{port->number, devices::UniqueFd(ends[0])};
    const devices::UniqueFd far(ends[1]);
    enlargeBuffers(ends[0]);
    enlargeBuffers(ends[1]);
    constexpr int kBus = 0x10000;
    std::ofstream attach(kController + "attach");
    attach << port->number << ' ' << far.get() << ' ' << kBus + port->number << ' '
           << static_cast<int>(speed) << std::flush;
    if (!attach)
        throw std::runtime_error("USB/IP: cannot attach to port " + std::to_string(port->number) +
                                 " (root is needed)");
    return attached;
}

} // namespace autostereo::test::usbip

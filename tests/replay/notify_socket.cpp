#include "tests/replay/notify_socket.hpp"

#include <cerrno>
#include <cstring>
#include <poll.h>
#include <stdexcept>
#include <sys/socket.h>
#include <sys/un.h>
#include <system_error>
#include <utility>

namespace autostereo::test {

NotifySocket::NotifySocket(std::string path)
    : path_(std::move(path)), socket_(socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path_.size() >= sizeof address.sun_path) throw std::length_error(path_);
    std::memcpy(address.sun_path, path_.data(), path_.size());
    if (bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
        throw std::system_error(errno, std::generic_category(), path_);
}

bool NotifySocket::waitFor(const std::string& message, std::chrono::milliseconds limit) {
    const auto deadline = std::chrono::steady_clock::now() + limit;
    while (true) {
        const auto left =
            duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
        pollfd waiting{socket_.get(), POLLIN, 0};
        if (poll(&waiting, 1, std::max(0, static_cast<int>(left.count()))) <= 0) return false;
        char text[512];
        const ssize_t length = recv(socket_.get(), text, sizeof text, 0);
        if (length < 0) return false;
        if (std::string(text, static_cast<std::size_t>(length)) == message) return true;
    }
}

} // namespace autostereo::test

#pragma once

#include "devices/unique_fd.hpp"

#include <cstdint>
#include <string>
#include <system_error>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>

namespace autostereo::test {

/// A connection to a port of this machine, with 30 s of patience. Throws std::system_error.
[[nodiscard]] inline devices::UniqueFd dial(std::uint16_t port) {
    devices::UniqueFd socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    const timeval patience{30, 0};
    setsockopt(socket.get(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    const sockaddr_in place{AF_INET, htons(port), {htonl(INADDR_LOOPBACK)}, {}};
    if (::connect(socket.get(), reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0)
        throw std::system_error(errno, std::generic_category(), "connect");
    return socket;
}

inline void say(const devices::UniqueFd& socket, const std::string& bytes) {
    for (std::size_t said = 0; said < bytes.size();) {
        const ssize_t count =
            ::send(socket.get(), bytes.data() + said, bytes.size() - said, MSG_NOSIGNAL);
        if (count <= 0) return; // it hears no more: what it says is what counts
        said += static_cast<std::size_t>(count);
    }
}

/// Everything until the other side ends.
[[nodiscard]] inline std::string hear(const devices::UniqueFd& socket) {
    std::string heard;
    char part[4096];
    for (ssize_t count = 0; (count = ::recv(socket.get(), part, sizeof part, 0)) > 0;)
        heard.append(part, static_cast<std::size_t>(count));
    return heard;
}

/// What raw bytes are answered with.
[[nodiscard]] inline std::string answerTo(std::uint16_t port, const std::string& bytes) {
    const devices::UniqueFd socket = dial(port);
    say(socket, bytes);
    return hear(socket);
}

/// The three digits of an answer; 0: it is none.
[[nodiscard]] inline int statusOf(const std::string& answer) {
    return answer.starts_with("HTTP/1.1 ") && answer.size() > 12 ? std::stoi(answer.substr(9, 3))
                                                                 : 0;
}

} // namespace autostereo::test

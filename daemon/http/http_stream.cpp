#include "daemon/http/http_stream.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <poll.h>
#include <sys/socket.h>

namespace autostereo::daemon {

namespace {

devices::TimePoint now() { return devices::SteadyClock().now(); }

bool again() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

} // namespace

HttpStream::HttpStream(int socket, const HttpLimits& limits)
    : socket_(socket), limits_(limits), readUntil_(now() + limits.request) {}

bool HttpStream::waitFor(short event, devices::TimePoint until) const {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - now()).count();
    if (left <= 0) return false;
    pollfd waiting{socket_, event, 0};
    return ::poll(&waiting, 1, static_cast<int>(left)) >= 0 || errno == EINTR;
}

ssize_t HttpStream::receive(char* to, std::size_t size) {
    while (now() < readUntil_) {
        const ssize_t count = ::recv(socket_, to, size, 0);
        if (count >= 0 || !again()) return count;
        if (!waitFor(POLLIN, readUntil_)) break;
    }
    late_ = true;
    return -1;
}

HttpStream::Head HttpStream::readHead() {
    constexpr const char* kEnd = "\r\n\r\n";
    std::array<char, 2048> part{};
    std::size_t looked = 0;
    while (received_.find(kEnd, looked) == std::string::npos) {
        if (received_.size() > limits_.head) return Head::TooLarge;
        looked = received_.size() - std::min(received_.size(), std::strlen(kEnd) - 1);
        const ssize_t count = receive(part.data(), part.size());
        if (count <= 0) return late_ ? Head::Late : Head::Gone;
        received_.append(part.data(), static_cast<std::size_t>(count));
    }
    return received_.find(kEnd) > limits_.head ? Head::TooLarge : Head::Whole;
}

ssize_t HttpStream::read(char* to, std::size_t size) {
    if (read_ == received_.size()) return receive(to, size);
    const std::size_t count = std::min(size, received_.size() - read_);
    std::memcpy(to, received_.data() + read_, count);
    read_ += count;
    return static_cast<ssize_t>(count);
}

ssize_t HttpStream::write(const char* from, std::size_t size) {
    if (!writeUntil_) writeUntil_ = now() + limits_.reply;
    while (now() < *writeUntil_) {
        const ssize_t count = ::send(socket_, from, size, MSG_NOSIGNAL);
        if (count >= 0 || !again()) return count;
        if (!waitFor(POLLOUT, *writeUntil_)) break;
    }
    return -1;
}

void HttpStream::end() {
    ::shutdown(socket_, SHUT_WR);
    // Closing with bytes unread would take the reply away from who has not read it yet.
    readUntil_ = now() + HttpLimits::kBye;
    std::array<char, 2048> rest{};
    while (receive(rest.data(), rest.size()) > 0) {
    }
}

/// Nobody asks who it is: what is allowed does not depend on it.
void HttpStream::get_remote_ip_and_port(std::string& /*ip*/, int& port) const { port = 0; }
void HttpStream::get_local_ip_and_port(std::string& /*ip*/, int& port) const { port = 0; }

} // namespace autostereo::daemon

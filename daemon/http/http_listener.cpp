#include "daemon/http/http_listener.hpp"

#include "daemon/control/control_socket.hpp"
#include "daemon/http/http_limits.hpp"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>
#include <string_view>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

namespace autostereo::daemon {

namespace {

constexpr std::string_view kFull = "HTTP/1.1 503 Service Unavailable\r\nConnection: close\r\n"
                                   "Content-Length: 0\r\n\r\n";

/// A socket address of either family.
union Place {
    sockaddr any;
    sockaddr_in four;
    sockaddr_in6 six;
};

[[noreturn]] void fail(const config::ListenAddress& address, int cause) {
    throw ControlError("http: cannot listen on " + address.address + " port " +
                       std::to_string(address.port) + ": " + std::strerror(cause));
}

devices::UniqueFd listenOn(const config::ListenAddress& address) {
    Place place{};
    socklen_t size = sizeof place.four;
    place.four = {AF_INET, htons(address.port), {}, {}};
    if (inet_pton(AF_INET, address.address.c_str(), &place.four.sin_addr) != 1) {
        place.six = {AF_INET6, htons(address.port), 0, {}, 0};
        size = sizeof place.six;
        if (inet_pton(AF_INET6, address.address.c_str(), &place.six.sin6_addr) != 1)
            fail(address, EADDRNOTAVAIL);
    }
    devices::UniqueFd socket(
        ::socket(place.any.sa_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    const int on = 1; // else a restart would wait for the kernel to forget old connections
    if (!socket || setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) != 0 ||
        ::bind(socket.get(), &place.any, size) != 0 ||
        ::listen(socket.get(), static_cast<int>(HttpLimits::kWaiting)) != 0)
        fail(address, errno);
    return socket;
}

std::uint16_t portOf(const devices::UniqueFd& socket) {
    Place place{};
    socklen_t size = sizeof place;
    ::getsockname(socket.get(), &place.any, &size);
    return ntohs(place.any.sa_family == AF_INET6 ? place.six.sin6_port : place.four.sin_port);
}

} // namespace

HttpListener::HttpListener(const config::ListenAddress& address, Serve serve,
                           HttpRefusals& refusals)
    : serve_(std::move(serve)), refusals_(refusals), listener_(listenOn(address)),
      bell_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), port_(portOf(listener_)) {
    if (!bell_) throw ControlError("http: cannot make an event counter");
    threads_.emplace_back([this] { accept(); });
    for (std::size_t i = 0; i < HttpLimits::kAtOnce; ++i)
        threads_.emplace_back([this] { work(); });
}

HttpListener::~HttpListener() {
    {
        const std::scoped_lock lock(mutex_);
        ended_ = true;
        waiting_.clear();
        for (const int socket : served_)
            ::shutdown(socket, SHUT_RDWR);
    }
    changed_.notify_all();
    ::eventfd_write(bell_.get(), 1);
    for (std::thread& thread : threads_)
        thread.join();
}

void HttpListener::accept() {
    pthread_setname_np(pthread_self(), "http");
    constexpr std::chrono::milliseconds kNoDescriptors{200}; // not at once again
    pollfd waiting[]{{listener_.get(), POLLIN, 0}, {bell_.get(), POLLIN, 0}};
    while (true) {
        ::poll(waiting, 2, -1);
        if (waiting[1].revents != 0) return;
        devices::UniqueFd socket(
            ::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
        if (!socket) {
            if (errno == EMFILE || errno == ENFILE) std::this_thread::sleep_for(kNoDescriptors);
            continue;
        }
        const std::scoped_lock lock(mutex_);
        if (waiting_.size() < HttpLimits::kWaiting) {
            waiting_.push_back(std::move(socket));
            changed_.notify_one();
        } else {
            refusals_.note(503);
            ::send(socket.get(), kFull.data(), kFull.size(), MSG_NOSIGNAL);
        }
    }
}

void HttpListener::work() {
    pthread_setname_np(pthread_self(), "http-worker");
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return ended_ || !waiting_.empty(); });
        if (ended_) return;
        std::optional<devices::UniqueFd> socket(std::move(waiting_.front()));
        waiting_.pop_front();
        const int number = socket->get();
        served_.insert(number);
        lock.unlock();
        serve_(number);
        lock.lock();
        served_.erase(number);
        socket.reset(); // only now: its number may not be another's while it is noted here
    }
}

} // namespace autostereo::daemon

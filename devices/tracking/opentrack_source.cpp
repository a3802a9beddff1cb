#include "devices/tracking/opentrack_source.hpp"

#include "devices/input.hpp"
#include "devices/tracking/opentrack_packet.hpp"

#include <array>
#include <cerrno>
#include <cstring>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <pthread.h>
#include <sys/socket.h>

namespace autostereo::devices {

namespace {

constexpr int kSliceMs = 50; // longest time without a look at the stop token
constexpr int kBatch = 32;
constexpr Duration kPollRest = std::chrono::milliseconds(2);
/// What waits in the kernel is old when it is read: no more of it than a batch.
constexpr int kKernelBytes = 16 * 1024;

[[noreturn]] void fail(const std::string& address, std::uint16_t port, const std::string& why) {
    throw DeviceError("opentrack: cannot listen on " + address + ":" + std::to_string(port) + ": " +
                      why);
}

sockaddr_in addressOf(const std::string& address, std::uint16_t port) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(port);
    if (inet_pton(AF_INET, address.c_str(), &place.sin_addr) != 1)
        fail(address, port, "no IPv4 address in digits");
    if (place.sin_addr.s_addr == htonl(INADDR_ANY))
        fail(address, port, "all addresses at once; name this machine's own one");
    return place;
}

} // namespace

OpentrackSource::OpentrackSource(const std::string& address, std::uint16_t port,
                                 const ViewerParams& params, const glm::dvec3& nominal,
                                 Clock& clock)
    : pose_(params.pose), nominal_(nominal), spacingM_(params.spacingM), clock_(clock) {
    sockaddr_in place = addressOf(address, port);
    socket_ = UniqueFd(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    if (!socket_) fail(address, port, std::strerror(errno));
    ::setsockopt(socket_.get(), SOL_SOCKET, SO_RCVBUF, &kKernelBytes, sizeof kKernelBytes);
    socklen_t size = sizeof place;
    auto* generic = reinterpret_cast<sockaddr*>(&place);
    if (::bind(socket_.get(), generic, size) != 0 ||
        ::getsockname(socket_.get(), generic, &size) != 0)
        fail(address, port, std::strerror(errno));
    port_ = ntohs(place.sin_port);
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void OpentrackSource::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "opentrack");
    while (!stop.stop_requested()) {
        pollfd waiting{socket_.get(), POLLIN, 0};
        if (::poll(&waiting, 1, kSliceMs) <= 0) continue;
        takeBatch();
        clock_.sleepUntil(clock_.now() + kPollRest);
    }
}

void OpentrackSource::takeBatch() {
    std::array<std::byte, 2 * kOpentrackBytes> bytes{}; // one that is longer shows
    std::optional<EyeSample> newest;
    for (int i = 0; i < kBatch; ++i) {
        const ssize_t size = ::recv(socket_.get(), bytes.data(), bytes.size(), 0);
        if (size < 0) break; // nothing there, or an error that is reported once
        received_.fetch_add(1, std::memory_order_relaxed);
        const auto head = parseOpentrack(std::span(bytes).first(static_cast<std::size_t>(size)));
        const auto eyes =
            head ? std::optional(eyesOf(*head, pose_, nominal_, spacingM_)) : std::nullopt;
        if (!eyes || !isPlausible(*eyes)) {
            damaged_.fetch_add(1, std::memory_order_relaxed);
            continue;
        }
        if (newest) limited_.fetch_add(1, std::memory_order_relaxed);
        newest = EyeSample{clock_.now(), *eyes};
    }
    if (!newest) return;
    accepted_.fetch_add(1, std::memory_order_relaxed);
    queue_.push(*newest);
}

std::optional<EyeSample> OpentrackSource::next(TimePoint /*now*/) { return queue_.take(); }

EyeCounters OpentrackSource::counters() const noexcept {
    return {received_.load(), accepted_.load(), damaged_.load(), limited_.load()};
}

} // namespace autostereo::devices

#pragma once

#include "config/listen_address.hpp"
#include "daemon/http/http_refusals.hpp"
#include "devices/unique_fd.hpp"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace autostereo::daemon {

/// A TCP port and the threads that serve its connections: so many at once, so many more wait, and
/// whoever comes then is turned away with 503. Destruction cuts off those that are served.
class HttpListener {
  public:
    /// Serves one connection: a non-blocking socket, closed afterwards. Called on any thread, by
    /// several at once.
    using Serve = std::function<void(int socket)>;
    /// `refusals`, which counts those turned away, must outlive it. Throws ControlError.
    HttpListener(const config::ListenAddress& address, Serve serve, HttpRefusals& refusals);
    ~HttpListener();
    HttpListener(const HttpListener&) = delete;
    HttpListener& operator=(const HttpListener&) = delete;

    [[nodiscard]] std::uint16_t port() const { return port_; }

  private:
    void accept();
    void work();

    Serve serve_;
    HttpRefusals& refusals_;
    devices::UniqueFd listener_;
    devices::UniqueFd bell_; ///< rung by the end
    std::uint16_t port_;

    std::mutex mutex_; ///< of what follows
    std::condition_variable changed_;
    std::deque<devices::UniqueFd> waiting_;
    std::set<int> served_;
    bool ended_ = false;
    std::vector<std::thread> threads_; // last: they use all of the above
};

} // namespace autostereo::daemon

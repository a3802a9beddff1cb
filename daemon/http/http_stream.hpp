#pragma once

#include "daemon/http/http_limits.hpp"
#include "devices/clock.hpp"

#include <httplib.h>

#include <cstddef>
#include <optional>
#include <string>

namespace autostereo::daemon {

/// One connection as httplib wants it: bytes in and out, none later than allowed. Does not own the
/// socket, which has to be non-blocking. Thread-bound.
class HttpStream final : public httplib::Stream {
  public:
    HttpStream(int socket, const HttpLimits& limits);

    enum class Head { Whole, TooLarge, Late, Gone };
    /// Takes in request line and headers before anybody parses them: their size is bounded as a
    /// whole, which httplib does for each line only.
    [[nodiscard]] Head readHead();
    /// Says the last word and waits a little for the other side to hear it.
    void end();

    [[nodiscard]] bool is_readable() const override { return true; }
    [[nodiscard]] bool is_writable() const override { return true; }
    /// Bytes; -1 where they come too late or the connection is gone.
    ssize_t read(char* to, std::size_t size) override;
    ssize_t write(const char* from, std::size_t size) override;
    using httplib::Stream::write;
    void get_remote_ip_and_port(std::string& ip, int& port) const override;
    void get_local_ip_and_port(std::string& ip, int& port) const override;
    [[nodiscard]] socket_t socket() const override { return socket_; }

  private:
    [[nodiscard]] bool waitFor(short event, devices::TimePoint until) const;
    /// What recv says, once there is something; -1 after `readUntil_`.
    ssize_t receive(char* to, std::size_t size);

    int socket_;
    HttpLimits limits_;
    devices::TimePoint readUntil_;
    std::optional<devices::TimePoint> writeUntil_; ///< none before the first byte of the reply
    std::string received_;
    std::size_t read_ = 0; ///< of those
    bool late_ = false;
};

} // namespace autostereo::daemon

#pragma once

#include "daemon/control/control_server.hpp"
#include "devices/clock.hpp"
#include "devices/unique_fd.hpp"

#include <optional>
#include <string>

namespace autostereo::daemon {

/// One connection: bytes in until a line is whole, an answer out, and how long each may take.
/// Thread-bound; nothing waits.
class ControlClient {
  public:
    ControlClient(devices::UniqueFd socket, devices::TimePoint now);

    [[nodiscard]] int socket() const { return socket_.get(); }
    /// What poll is to wait for.
    [[nodiscard]] short events() const;
    /// Whether it is over and can be forgotten.
    [[nodiscard]] bool done(devices::TimePoint now) const;

    /// Takes in what is there.
    void read();
    /// The next request, once its line is whole and the one before is answered. What cannot be
    /// taken is answered at once.
    [[nodiscard]] std::optional<ControlRequest> next(devices::TimePoint now);
    /// Queues the answer to the last request.
    void answer(ControlReply reply, devices::TimePoint now);
    /// The answer is the last word.
    void refuse(const std::string& what, devices::TimePoint now);
    /// Writes as much as fits.
    void write(devices::TimePoint now);
    void lose() { lost_ = true; }

  private:
    [[nodiscard]] std::optional<std::string> nextLine(devices::TimePoint now);

    devices::UniqueFd socket_;
    devices::TimePoint since_; ///< of the last thing that happened
    std::string received_;
    std::optional<ControlReply> reply_; ///< on its way
    std::size_t written_ = 0;
    bool waiting_ = false; ///< for the program's answer
    bool atEnd_ = false;   ///< the other side sends no more
    bool closing_ = false; ///< after what is on its way
    bool lost_ = false;
};

} // namespace autostereo::daemon

#include "daemon/control/control_connection.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>

#include <poll.h>
#include <sys/socket.h>

namespace autostereo::daemon {

namespace {

constexpr std::chrono::seconds kPatience{10};

/// One send; bytes that went, 0 where none fit, -1 where the connection is gone.
ssize_t sendSome(int socket, const void* from, std::size_t count) {
    const ssize_t sent = ::send(socket, from, count, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent >= 0) return sent;
    return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR ? 0 : -1;
}

} // namespace

ControlClient::ControlClient(devices::UniqueFd socket, devices::TimePoint now)
    : socket_(std::move(socket)), since_(now) {}

short ControlClient::events() const {
    if (reply_) return POLLOUT;
    return waiting_ || closing_ || atEnd_ ? 0 : POLLIN;
}

bool ControlClient::done(devices::TimePoint now) const {
    if (lost_) return true;
    if (reply_) return now - since_ > kPatience;
    if (waiting_) return false; // the program's own time
    return closing_ || atEnd_ || now - since_ > kPatience;
}

void ControlClient::read() {
    char part[kLongestRequest];
    const ssize_t count = ::recv(socket_.get(), part, sizeof part, MSG_DONTWAIT);
    if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return;
    if (count <= 0)
        atEnd_ = true;
    else // the clock does not start anew: a request has to be whole in its time
        received_.append(part, static_cast<std::size_t>(count));
}

std::optional<std::string> ControlClient::nextLine(devices::TimePoint now) {
    if (reply_ || waiting_ || closing_ || lost_) return std::nullopt;
    const std::size_t end = received_.find('\n');
    if (std::min(end, received_.size()) > kLongestRequest)
        refuse("request: longer than " + std::to_string(kLongestRequest) + " bytes", now);
    else if (end != std::string::npos) {
        std::string line = received_.substr(0, end);
        received_.erase(0, end + 1);
        since_ = now;
        return line;
    }
    return std::nullopt;
}

std::optional<ControlRequest> ControlClient::next(devices::TimePoint now) {
    while (const auto line = nextLine(now)) {
        try {
            ControlRequest request = parseRequest(*line);
            waiting_ = true;
            return request;
        } catch (const RequestError& error) {
            answer(refusal(error.what(), kBadRequest), now);
        }
    }
    return std::nullopt;
}

void ControlClient::answer(ControlReply reply, devices::TimePoint now) {
    waiting_ = false;
    reply.line += '\n';
    reply_ = std::move(reply);
    written_ = 0;
    since_ = now;
    write(now);
}

void ControlClient::refuse(const std::string& what, devices::TimePoint now) {
    closing_ = true;
    answer(refusal(what, kBadRequest), now);
}

void ControlClient::write(devices::TimePoint now) {
    if (!reply_) return;
    const std::string& line = reply_->line;
    const std::size_t bytes = reply_->bytes ? reply_->bytes->size() : 0;
    while (written_ < line.size() + bytes) {
        const ssize_t sent =
            written_ < line.size()
                ? sendSome(socket_.get(), line.data() + written_, line.size() - written_)
                : sendSome(socket_.get(), reply_->bytes->data() + (written_ - line.size()),
                           line.size() + bytes - written_);
        if (sent < 0) lost_ = true;
        if (sent <= 0) return;
        written_ += static_cast<std::size_t>(sent);
        since_ = now;
    }
    reply_.reset();
}

} // namespace autostereo::daemon

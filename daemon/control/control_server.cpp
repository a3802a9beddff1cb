#include "daemon/control/control_server.hpp"

#include "daemon/control/control_connection.hpp"
#include "daemon/control/control_socket.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <chrono>
#include <stdexcept>

#include <poll.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

namespace autostereo::daemon {

namespace {

constexpr std::size_t kMostClients = 64; // the others wait in the kernel's queue
constexpr int kTickMs = 200;             // between looks at who takes too long

devices::TimePoint now() { return devices::SteadyClock().now(); }

} // namespace

ControlReply refusal(const std::string& what, int code) {
    const nlohmann::ordered_json line{{"ok", false}, {"error", what}, {"code", code}};
    return {line.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace)};
}

ControlServer::ControlServer(const std::filesystem::path& socket, std::optional<gid_t> group)
    : path_(std::filesystem::absolute(socket)), group_(group), listener_(listenAt(path_, group)),
      bell_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    if (!bell_) throw ControlError("control: cannot make an event counter");
    thread_ = std::thread([this] { run(); });
}

ControlServer::~ControlServer() {
    ended_ = true;
    ::eventfd_write(bell_.get(), 1);
    thread_.join();
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

std::optional<ControlServer::Asked> ControlServer::take() {
    const std::scoped_lock lock(mutex_);
    if (asked_.empty()) return std::nullopt;
    Asked first = std::move(asked_.front());
    asked_.erase(asked_.begin());
    return first;
}

void ControlServer::answer(std::uint64_t client, ControlReply reply) {
    {
        const std::scoped_lock lock(mutex_);
        answers_.emplace_back(client, std::move(reply));
    }
    ::eventfd_write(bell_.get(), 1);
}

void ControlServer::run() {
    pthread_setname_np(pthread_self(), "control");
    while (!ended_) {
        const bool room = clients_.size() < kMostClients;
        std::vector<pollfd> waiting{{bell_.get(), POLLIN, 0},
                                    {listener_.get(), static_cast<short>(room ? POLLIN : 0), 0}};
        std::vector<std::uint64_t> numbers;
        for (const auto& [number, client] : clients_) {
            waiting.push_back({client->socket(), client->events(), 0});
            numbers.push_back(number);
        }
        ::poll(waiting.data(), waiting.size(), kTickMs);
        eventfd_t rung = 0;
        ::eventfd_read(bell_.get(), &rung);
        deliver();
        for (std::size_t i = 0; i < numbers.size(); ++i)
            serve(numbers[i], *clients_.at(numbers[i]), waiting[i + 2].revents);
        if (waiting[1].revents != 0) accept();
        closeDone();
    }
}

void ControlServer::accept() {
    devices::UniqueFd socket(
        ::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (!socket) { // no descriptors left: not at once again
        std::this_thread::sleep_for(std::chrono::milliseconds(kTickMs));
        return;
    }
    const auto peer = peerOf(socket.get());
    auto client = std::make_unique<ControlClient>(std::move(socket), now());
    if (!peer || !isAllowed(*peer, ::geteuid(), group_))
        client->refuse("control: not allowed (root, the program's own user and the members of "
                       "control.group are)",
                       now());
    clients_.emplace(next_++, std::move(client));
}

void ControlServer::serve(std::uint64_t number, ControlClient& client, short events) {
    if ((events & POLLOUT) != 0) client.write(now());
    if ((events & POLLIN) != 0) client.read();
    if (auto request = client.next(now())) {
        const std::scoped_lock lock(mutex_);
        asked_.push_back({number, std::move(*request)});
    }
    if ((events & (POLLERR | POLLNVAL)) != 0) client.lose();
    // Hung up with nothing to read: what is asked for here nobody will hear.
    if ((events & POLLHUP) != 0 && (events & POLLIN) == 0) client.lose();
}

void ControlServer::deliver() {
    std::vector<std::pair<std::uint64_t, ControlReply>> answers;
    {
        const std::scoped_lock lock(mutex_);
        answers.swap(answers_);
    }
    for (auto& [number, reply] : answers)
        if (const auto client = clients_.find(number); client != clients_.end())
            client->second->answer(std::move(reply), now());
}

void ControlServer::closeDone() {
    std::erase_if(clients_, [](const auto& entry) { return entry.second->done(now()); });
}

} // namespace autostereo::daemon

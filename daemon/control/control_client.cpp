#include "daemon/control/control_client.hpp"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <sys/socket.h>

namespace autostereo::daemon {

namespace {

constexpr std::size_t kLongestAnswer = std::size_t{1} << 20; // bytes of JSON
constexpr std::size_t kMostBytes = std::size_t{1} << 30;     // behind it

/// A refusal may come before all is sent, and closes the way there: what counts is the answer.
void sendLine(int socket, std::string line) {
    line += '\n';
    for (std::size_t sent = 0; sent < line.size();) {
        const ssize_t count = ::send(socket, line.data() + sent, line.size() - sent, MSG_NOSIGNAL);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return;
        sent += static_cast<std::size_t>(count);
    }
}

/// Bytes that came, at most `most`; throws at the end and where nothing comes.
std::size_t receive(int socket, char* to, std::size_t most) {
    while (true) {
        const ssize_t count = ::recv(socket, to, most, 0);
        if (count > 0) return static_cast<std::size_t>(count);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK))
            throw std::runtime_error("control: the program does not answer");
        throw std::runtime_error("control: the program ended the connection" +
                                 std::string(count < 0 ? ": " : "") +
                                 (count < 0 ? std::strerror(errno) : ""));
    }
}

std::size_t announcedBytes(const std::string& line) {
    const auto answer = nlohmann::json::parse(line, nullptr, false);
    if (!answer.is_object()) throw std::runtime_error("control: an answer that is no JSON");
    const auto found = answer.find("bytes");
    if (found == answer.end()) return 0;
    if (!found->is_number_unsigned() || found->get<std::size_t>() > kMostBytes)
        throw std::runtime_error("control: an answer of a size that cannot be");
    return found->get<std::size_t>();
}

} // namespace

ControlAnswer ask(int socket, const ControlRequest& request) {
    sendLine(socket, requestLine(request));
    std::string received;
    std::size_t end = std::string::npos;
    char part[4096];
    while (end == std::string::npos) {
        if (received.size() > kLongestAnswer)
            throw std::runtime_error("control: an answer without an end");
        const std::size_t from = received.size();
        received.append(part, receive(socket, part, sizeof part));
        end = received.find('\n', from);
    }
    ControlAnswer answer{received.substr(0, end),
                         {received.begin() + static_cast<std::ptrdiff_t>(end) + 1, received.end()}};
    const std::size_t wanted = announcedBytes(answer.line);
    std::size_t have = std::min(answer.bytes.size(), wanted);
    answer.bytes.resize(wanted);
    while (have < wanted)
        have += receive(socket, reinterpret_cast<char*>(answer.bytes.data()) + have, wanted - have);
    return answer;
}

} // namespace autostereo::daemon

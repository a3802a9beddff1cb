#include "daemon/journal_sink.hpp"

#include "devices/unique_fd.hpp"

#include <spdlog/sinks/base_sink.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <mutex>
#include <string_view>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

namespace autostereo::daemon {

namespace {

int priorityOf(spdlog::level::level_enum level) {
    switch (level) {
    case spdlog::level::critical:
        return 2;
    case spdlog::level::err:
        return 3;
    case spdlog::level::warn:
        return 4;
    case spdlog::level::info:
        return 6;
    default:
        return 7;
    }
}

/// The word before the first ": ".
std::string_view partOf(std::string_view message) {
    const std::size_t colon = message.find(": ");
    const auto part = message.substr(0, colon == std::string_view::npos ? 0 : colon);
    const auto isWord = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
    };
    return std::ranges::all_of(part, isWord) ? part : std::string_view{};
}

/// A field on a line of its own; a value of several lines with its length before it.
void add(std::string& datagram, std::string_view name, std::string_view value) {
    datagram += name;
    if (value.find('\n') == std::string_view::npos) {
        datagram += '=';
    } else {
        datagram += '\n';
        for (unsigned byte = 0; byte < 8; ++byte) // little-endian
            datagram += static_cast<char>(std::uint64_t{value.size()} >> (8 * byte) & 0xff);
    }
    datagram += value;
    datagram += '\n';
}

class JournalSink final : public spdlog::sinks::base_sink<std::mutex> {
  public:
    explicit JournalSink(const std::filesystem::path& socket)
        : fd_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
        place_.sun_family = AF_UNIX;
        const std::string path = socket.string();
        if (path.size() < sizeof place_.sun_path) std::ranges::copy(path, place_.sun_path);
    }

  private:
    void sink_it_(const spdlog::details::log_msg& message) override {
        const std::string_view text(message.payload.data(), message.payload.size());
        std::string datagram;
        add(datagram, "MESSAGE", text);
        add(datagram, "PRIORITY", std::to_string(priorityOf(message.level)));
        add(datagram, "SYSLOG_IDENTIFIER", "autostereo");
        add(datagram, "TID", std::to_string(message.thread_id));
        if (const auto part = partOf(text); !part.empty()) add(datagram, "AUTOSTEREO_PART", part);
        if (!send(datagram)) spillToStderr(message);
    }
    void flush_() override {}

    [[nodiscard]] bool send(const std::string& datagram) {
        const auto sent = ::sendto(fd_.get(), datagram.data(), datagram.size(), MSG_NOSIGNAL,
                                   reinterpret_cast<const sockaddr*>(&place_), sizeof place_);
        return sent == static_cast<ssize_t>(datagram.size());
    }
    void spillToStderr(const spdlog::details::log_msg& message) {
        spdlog::memory_buf_t line;
        formatter_->format(message, line);
        std::fwrite(line.data(), 1, line.size(), stderr);
    }

    devices::UniqueFd fd_;
    sockaddr_un place_{};
};

} // namespace

bool isJournal(const char* journalStream, int descriptor) {
    unsigned long long device = 0, inode = 0;
    struct stat is {};
    return journalStream != nullptr &&
           std::sscanf(journalStream, "%20llu:%20llu", &device, &inode) == 2 &&
           ::fstat(descriptor, &is) == 0 && is.st_dev == device && is.st_ino == inode;
}

std::shared_ptr<spdlog::sinks::sink> journalSink(const std::filesystem::path& socket) {
    return std::make_shared<JournalSink>(socket);
}

} // namespace autostereo::daemon

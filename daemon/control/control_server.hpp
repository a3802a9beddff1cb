#pragma once

#include "daemon/control/control_request.hpp"
#include "devices/unique_fd.hpp"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <sys/types.h>

namespace autostereo::daemon {

class ControlClient;

/// What a request is answered with: a JSON object in one line, and bytes behind it that the object
/// announces as "bytes".
struct ControlReply {
    std::string line;
    std::shared_ptr<const std::vector<std::uint8_t>> bytes{};
};
/// What a request that means nothing ends its command with.
inline constexpr int kBadRequest = 2;
/// {"ok": false, "error": what, "code": exit code of the command that asked}
[[nodiscard]] ControlReply refusal(const std::string& what, int code);

/// The socket's side of a running program: a thread reads requests and writes answers, and never
/// makes the program wait. Bounded: so many connections, one request of each at a time, 4096 bytes
/// a line, 10 s for a request and for every piece of an answer. Who is not allowed is told so.
/// `take` and `answer` belong to the thread that constructs it.
class ControlServer {
  public:
    /// Throws ControlError.
    ControlServer(const std::filesystem::path& socket, std::optional<gid_t> group);
    ~ControlServer();
    ControlServer(const ControlServer&) = delete;
    ControlServer& operator=(const ControlServer&) = delete;

    struct Asked {
        std::uint64_t client;
        ControlRequest request;
    };
    /// One that waits for its answer, if any; never waits itself.
    [[nodiscard]] std::optional<Asked> take();
    /// Clients that are gone by now hear nothing.
    void answer(std::uint64_t client, ControlReply reply);

  private:
    void run();
    void accept();
    void serve(std::uint64_t number, ControlClient& client, short events);
    void deliver();
    void closeDone();

    std::filesystem::path path_;
    std::optional<gid_t> group_;
    devices::UniqueFd listener_;
    devices::UniqueFd bell_; ///< rung by answers and by the end
    std::atomic<bool> ended_{false};
    std::map<std::uint64_t, std::unique_ptr<ControlClient>> clients_; ///< the thread's own
    std::uint64_t next_ = 0;

    std::mutex mutex_; ///< of what follows
    std::vector<Asked> asked_;
    std::vector<std::pair<std::uint64_t, ControlReply>> answers_;
    std::thread thread_; // last: it uses all of the above
};

} // namespace autostereo::daemon

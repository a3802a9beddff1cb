#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

namespace autostereo::daemon {

/// A request that cannot be taken; one line.
class RequestError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// What a running program is asked and told, each as a JSON object in a line of its own:
struct StatusRequest {};    ///< {"command": "status"}
struct SnapshotRequest {};  ///< {"command": "snapshot"}
struct RecordingRequest {}; ///< {"command": "recording"}: the last seconds, Matroska
struct ReloadRequest {};    ///< {"command": "reload"}
/// {"command": "set", "name": "scale", "value": "0.5"}; the value may be a number, too.
struct SetRequest {
    std::string name, value;
};
/// {"command": "show", "what": "numbers"}
struct ShowRequest {
    std::string what;
};
using ControlRequest = std::variant<StatusRequest, SnapshotRequest, RecordingRequest, ReloadRequest,
                                    SetRequest, ShowRequest>;

/// Longer lines are refused unread.
inline constexpr std::size_t kLongestRequest = 4096; // bytes

/// Throws RequestError. What the words mean to the program is for the program to say. Reentrant.
[[nodiscard]] ControlRequest parseRequest(std::string_view line);
/// The line that `parseRequest` reads, without its end. Bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string requestLine(const ControlRequest& request);

} // namespace autostereo::daemon

#include "daemon/control/control_request.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <initializer_list>

namespace autostereo::daemon {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kCommands = "status, snapshot, recording, reload, set, show";

std::string quoted(const std::string& text) {
    return Json(text).dump(-1, ' ', true, Json::error_handler_t::replace);
}

void allowOnly(const Json& request, std::initializer_list<std::string_view> keys) {
    for (const auto& [key, value] : request.items())
        if (std::ranges::find(keys, key) == keys.end())
            throw RequestError("request: unknown key " + quoted(key));
}

std::string textOf(const Json& request, const char* key) {
    const auto found = request.find(key);
    if (found == request.end()) throw RequestError(std::string("request: ") + key + " is missing");
    if (!found->is_string()) throw RequestError(std::string("request: ") + key + " is no string");
    return found->get<std::string>();
}

SetRequest setRequest(const Json& request) {
    allowOnly(request, {"command", "name", "value"});
    std::string name = textOf(request, "name");
    const auto value = request.find("value");
    if (value != request.end() && value->is_number()) return {std::move(name), value->dump()};
    return {std::move(name), textOf(request, "value")};
}

} // namespace

ControlRequest parseRequest(std::string_view line) {
    if (line.size() > kLongestRequest)
        throw RequestError("request: longer than " + std::to_string(kLongestRequest) + " bytes");
    const Json request = Json::parse(line, nullptr, false);
    if (request.is_discarded()) throw RequestError("request: no JSON");
    if (!request.is_object()) throw RequestError("request: no JSON object");
    const std::string command = textOf(request, "command");
    if (command == "set") return setRequest(request);
    if (command == "show") {
        allowOnly(request, {"command", "what"});
        return ShowRequest{textOf(request, "what")};
    }
    allowOnly(request, {"command"});
    if (command == "status") return StatusRequest{};
    if (command == "snapshot") return SnapshotRequest{};
    if (command == "recording") return RecordingRequest{};
    if (command == "reload") return ReloadRequest{};
    throw RequestError("request: command " + quoted(command).substr(0, 80) +
                       " is unknown (allowed " + std::string(kCommands) + ")");
}

std::string requestLine(const ControlRequest& request) {
    struct Writer {
        Json operator()(const StatusRequest& /*request*/) const { return {{"command", "status"}}; }
        Json operator()(const SnapshotRequest& /*request*/) const {
            return {{"command", "snapshot"}};
        }
        Json operator()(const RecordingRequest& /*request*/) const {
            return {{"command", "recording"}};
        }
        Json operator()(const ReloadRequest& /*request*/) const { return {{"command", "reload"}}; }
        Json operator()(const SetRequest& set) const {
            return {{"command", "set"}, {"name", set.name}, {"value", set.value}};
        }
        Json operator()(const ShowRequest& show) const {
            return {{"command", "show"}, {"what", show.what}};
        }
    };
    return std::visit(Writer{}, request).dump(-1, ' ', true, Json::error_handler_t::replace);
}

} // namespace autostereo::daemon

#include "daemon/control/control_request.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace autostereo::daemon {
namespace {

std::string refusalOf(const std::string& line) {
    try {
        (void)parseRequest(line);
    } catch (const RequestError& error) {
        return error.what();
    }
    return "no error";
}

TEST(ControlRequest, EveryRequestComesBackAsItWasSent) {
    EXPECT_TRUE(std::holds_alternative<StatusRequest>(parseRequest(requestLine(StatusRequest{}))));
    EXPECT_TRUE(
        std::holds_alternative<SnapshotRequest>(parseRequest(requestLine(SnapshotRequest{}))));
    EXPECT_TRUE(
        std::holds_alternative<RecordingRequest>(parseRequest(requestLine(RecordingRequest{}))));
    EXPECT_TRUE(std::holds_alternative<ReloadRequest>(parseRequest(requestLine(ReloadRequest{}))));
    for (const std::string text : {"scale", "\"", "a\nb", "\\", "\xC3\xA4", ""}) {
        const std::string set = requestLine(SetRequest{text, text + "!"});
        EXPECT_EQ(set.find('\n'), std::string::npos);
        EXPECT_EQ(std::get<SetRequest>(parseRequest(set)).name, text);
        EXPECT_EQ(std::get<SetRequest>(parseRequest(set)).value, text + "!");
        EXPECT_EQ(std::get<ShowRequest>(parseRequest(requestLine(ShowRequest{text}))).what, text);
    }
}

TEST(ControlRequest, ValuesMayBeNumbers) {
    const auto value = [](const std::string& json) {
        return std::get<SetRequest>(
                   parseRequest(R"({"command":"set","name":"scale","value":)" + json + "}"))
            .value;
    };
    EXPECT_EQ(value("0.5"), "0.5");
    EXPECT_EQ(value("-3"), "-3");
    EXPECT_EQ(value("\"0.50\""), "0.50");
}

TEST(ControlRequest, EveryBadRequestSaysWhatIsWrong) {
    const std::vector<std::pair<std::string, std::string>> bad{
        {"", "request: no JSON"},
        {"status", "request: no JSON"},
        {"{\"command\": \"status\"", "request: no JSON"},
        {"{\"command\": \"status\"} {}", "request: no JSON"},
        {"\"status\"", "request: no JSON object"},
        {"[]", "request: no JSON object"},
        {"null", "request: no JSON object"},
        {"{}", "request: command is missing"},
        {R"({"command": 7})", "request: command is no string"},
        {R"({"command": "stop"})",
         "request: command \"stop\" is unknown (allowed status, snapshot, "
         "recording, reload, set, show)"},
        {R"({"command": "a\nb"})", "request: command \"a\\nb\" is unknown (allowed status, "
                                   "snapshot, recording, reload, set, show)"},
        {R"({"command": "status", "json": true})", "request: unknown key \"json\""},
        {R"({"command": "show"})", "request: what is missing"},
        {R"({"command": "show", "what": []})", "request: what is no string"},
        {R"({"command": "set", "name": "scale"})", "request: value is missing"},
        {R"({"command": "set", "value": "1"})", "request: name is missing"},
        {R"({"command": "set", "name": "scale", "value": true})", "request: value is no string"},
        {R"({"command": "set", "name": "scale", "value": 1, "for": 2})",
         "request: unknown key \"for\""},
        {std::string(4097, ' '), "request: longer than 4096 bytes"},
        {std::string(4000, '['), "request: no JSON"},
        {"{\"command\": \"\xFF\"}", "request: no JSON"}};
    for (const auto& [line, message] : bad)
        EXPECT_EQ(refusalOf(line), message) << line.substr(0, 60);
}

} // namespace
} // namespace autostereo::daemon

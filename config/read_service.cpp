#include "config/read_service.hpp"

#include "config/units.hpp"
#include "devices/content_kind.hpp"

namespace autostereo::config {

namespace {

void readIdle(TomlReader& root, const std::filesystem::path& folder, IdleParams& idle) {
    auto table = root.table("idle");
    // The watchdog hears nothing while a picture is frozen: less than half of what it allows.
    const std::chrono::duration<double> freeze = idle.freeze;
    idle.freeze = units::durationFromMs(1e3 * table.number("freeze_s", {0, 4}, freeze.count()));
    const std::string content = table.text("content", "");
    if (content.empty()) return;
    if (!devices::contentKind(content))
        table.reject("content", '"' + content + "\" is of no kind that can be shown (allowed " +
                                    devices::kContentNames + ')');
    idle.content = folder / content;
}

void readMessages(TomlReader& root, IdleParams& idle) {
    auto table = root.table("messages");
    constexpr std::size_t kLongest = 200; // what a panel can show in letters that can be read
    const auto message = [&](const char* key, std::string& text) {
        text = table.text(key, text);
        if (text.size() > kLongest) table.reject(key, "is longer than 200 bytes");
    };
    message("starting", idle.startingText);
    message("no_input", idle.noInputText);
    message("depth_lost", idle.depthLostText);
    message("color_lost", idle.colorLostText);
    message("both_lost", idle.bothLostText);
    message("no_pairs", idle.noPairsText);
}

void readRest(TomlReader& root, RestParams& rest) {
    auto table = root.table("rest");
    constexpr Range kSpans{0, 64};
    rest.hours.clear();
    const auto hours =
        table.has("hours") ? table.words("hours", kSpans) : std::vector<std::string>{};
    for (const std::string& text : hours) {
        const auto span = openingSpan(text);
        if (span)
            rest.hours.push_back(*span);
        else
            table.reject("hours", '"' + text +
                                      "\" is no opening (allowed e.g. \"mon-fri 09:00-18:00\", "
                                      "\"sat,sun 10:00-16:30\", \"daily 20:00-02:00\")");
    }
    constexpr double kPercent = 100, kLongestS = 86400;
    rest.presenceM = table.number("presence_m", {0, 20}, rest.presenceM);
    rest.presenceShare =
        table.number("presence_percent", {0.01, 100}, kPercent * rest.presenceShare) / kPercent;
    const std::chrono::duration<double> leave = rest.leave;
    rest.leave =
        units::durationFromMs(1e3 * table.number("leave_s", {0, kLongestS}, leave.count()));
    const double offS = table.number("monitor_off_s", {0, kLongestS}, 0);
    if (offS > 0) rest.monitorOff = units::durationFromMs(1e3 * offS);
}

void readHttp(TomlReader& root, const std::filesystem::path& folder, HttpParams& http) {
    auto table = root.table("http");
    const std::string listen = table.text("listen", "");
    const bool remote = table.boolean("allow_remote", false);
    const std::string token = table.text("token_file", "");
    http.listen = listenAddress(listen);
    if (!listen.empty() && !http.listen)
        table.reject("listen", '"' + listen +
                                   "\" is no address with a port (allowed \"127.0.0.1:8787\", "
                                   "\"[::1]:8787\" or \"\")");
    else if (http.listen && !http.listen->loopback && !remote)
        table.reject("listen", '"' + listen +
                                   "\" can be reached from other machines (allowed with "
                                   "http.allow_remote = true)");
    http.tokenFile = token.empty() ? "" : (folder / token).lexically_normal().string();
}

void readRing(TomlReader& root, devices::RingParams& ring) {
    auto table = root.table("record");
    const std::chrono::duration<double> length = ring.length;
    ring.length = units::durationFromMs(1e3 * table.number("ring_s", {0, 600}, length.count()));
    // What is handed out is an answer on the control socket: 1 GiB at most.
    const int mib = static_cast<int>(ring.mostBytes >> 20U);
    ring.mostBytes = static_cast<std::size_t>(table.integer("ring_mib", {1, 768}, mib)) << 20U;
}

} // namespace

void readService(TomlReader& root, const std::filesystem::path& folder, Config& config) {
    auto control = root.table("control");
    config.control.socket = control.textOrAuto("socket", config.control.socket);
    config.control.group = control.text("group", config.control.group);
    readHttp(root, folder, config.http);
    readRing(root, config.ring);
    readIdle(root, folder, config.idle);
    readRest(root, config.rest);
    readMessages(root, config.idle);
}

} // namespace autostereo::config

#include "tests/replay/browser.hpp"

#include "tests/replay/kiosk.hpp"

#include <httplib.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <stdexcept>

namespace autostereo::test {

namespace {

constexpr const char* kDriver = "/usr/bin/chromedriver";
constexpr const char* kBrowser = "/usr/bin/chromium";

nlohmann::json capabilities(const std::string& folder) {
    const nlohmann::json arguments{"--headless=new",
                                   "--no-sandbox", // root has none
                                   "--disable-gpu",
                                   "--disable-dev-shm-usage",
                                   "--no-first-run",
                                   "--disable-background-networking",
                                   "--disable-component-update",
                                   "--disable-sync",
                                   "--hide-scrollbars",
                                   "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
                                   "--user-data-dir=" + folder};
    return {{"capabilities",
             {{"alwaysMatch",
               {{"goog:chromeOptions", {{"binary", kBrowser}, {"args", arguments}}},
                {"goog:loggingPrefs", {{"browser", "ALL"}}},
                {"timeouts", {{"script", 60'000}, {"pageLoad", 60'000}}}}}}}};
}

/// RFC 4648, as the driver sends pictures.
std::string decoded(const std::string& base64) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0, count = 0;
    for (const char digit : base64) {
        const std::size_t value = kDigits.find(digit);
        if (value == std::string_view::npos) continue; // padding
        bits = bits << 6U | static_cast<unsigned>(value);
        if ((count += 6) < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 255U);
    }
    return bytes;
}

} // namespace

std::optional<std::string> missingBrowser() {
    for (const char* program : {kBrowser, kDriver})
        if (!std::filesystem::exists(program)) return std::string(program) + " is not installed";
    return std::nullopt;
}

Browser::Browser() {
    ProgramCall call;
    call.program = kDriver;
    call.arguments = {"--port=0", "--log-level=SEVERE"};
    call.environment = {"HOME=" + folder_ / "", "DISPLAY=", "WAYLAND_DISPLAY="};
    driver_ = std::make_unique<RunningProgram>(call);
    static const std::regex started("started successfully on port ([0-9]+)");
    std::smatch port;
    std::string said;
    if (!eventually([&] { return said = driver_->out(), std::regex_search(said, port, started); },
                    std::chrono::milliseconds(30'000 * kSlower)))
        throw std::runtime_error("chromedriver does not start: " + said);
    port_ = std::stoi(port[1]);
    session_ =
        "/session/" +
        post("/session", capabilities(folder_ / "profile")).at("sessionId").get<std::string>();
}

Browser::~Browser() {
    httplib::Client driver("127.0.0.1", port_);
    driver.set_read_timeout(30);
    (void)driver.Delete(session_);
    driver_->signal(SIGTERM);
}

nlohmann::json Browser::post(const std::string& path, const nlohmann::json& body) {
    httplib::Client driver("127.0.0.1", port_);
    driver.set_read_timeout(120);
    const auto reply = driver.Post(path, body.dump(), "application/json");
    if (!reply) throw std::runtime_error("chromedriver: no answer to " + path);
    const auto json = nlohmann::json::parse(reply->body, nullptr, false);
    if (reply->status != 200 || !json.is_object())
        throw std::runtime_error("chromedriver: " + path + ": " + reply->body.substr(0, 500));
    return json.at("value");
}

void Browser::resize(int width, int height, bool phone) {
    (void)post(
        session_ + "/goog/cdp/execute",
        {{"cmd", "Emulation.setDeviceMetricsOverride"},
         {"params",
          {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", phone}}}});
}

void Browser::open(const std::string& address) {
    (void)post(session_ + "/url", {{"url", address}});
}

nlohmann::json Browser::run(const std::string& script, const nlohmann::json& arguments) {
    return post(session_ + "/execute/sync", {{"script", script}, {"args", arguments}});
}

void Browser::screenshot(const std::string& file) {
    const auto shot = post(session_ + "/goog/cdp/execute",
                           {{"cmd", "Page.captureScreenshot"},
                            {"params", {{"format", "png"}, {"captureBeyondViewport", true}}}});
    std::ofstream(file, std::ios::binary) << decoded(shot.at("data"));
}

nlohmann::json Browser::errors() {
    nlohmann::json severe = nlohmann::json::array();
    for (const auto& entry : post(session_ + "/se/log", {{"type", "browser"}}))
        if (entry.at("level") == "SEVERE") severe.push_back(entry.at("message"));
    return severe;
}

} // namespace autostereo::test

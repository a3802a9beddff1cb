#include "daemon/session/status.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <stdexcept>

namespace autostereo::daemon {

namespace {

using Json = nlohmann::ordered_json;

Json numberOrAuto(const std::optional<double>& number) {
    return number ? Json(*number) : Json("auto");
}

Json ageMs(std::optional<devices::TimePoint> then, devices::TimePoint now) {
    if (!then) return nullptr;
    return std::chrono::duration<double, std::milli>(now - *then).count();
}

Json sensorJson(const devices::SensorStatus& sensor, devices::TimePoint now) {
    return {{"state", sensorStateName(sensor.state)},
            {"last_frame_ms_ago", ageMs(sensor.lastFrame, now)},
            {"reason", sensor.reason}};
}

Json sensorsJson(const Status& status) {
    if (!status.sensors) return nullptr;
    return {{"depth", sensorJson(status.sensors->depth, status.now)},
            {"color", sensorJson(status.sensors->color, status.now)}};
}

Json eyeJson(const glm::dvec3& eye) { return {eye.x, eye.y, eye.z}; }

Json viewerJson(const Status& status) {
    if (!status.viewer) return nullptr;
    const ViewerStatus& viewer = *status.viewer;
    Json age = nullptr;
    if (viewer.lastSample)
        age = std::chrono::duration<double, std::milli>(status.now - *viewer.lastSample).count();
    return {{"source", viewer.source},
            {"tracked", viewer.tracked},
            {"last_sample_ms_ago", age},
            {"samples",
             {{"received", viewer.samples.received},
              {"accepted", viewer.samples.accepted},
              {"damaged", viewer.samples.damaged},
              {"limited", viewer.samples.limited},
              {"nobody", viewer.samples.nobody},
              {"disordered", viewer.disordered}}},
            {"eyes_m", {eyeJson(viewer.eyes.left), eyeJson(viewer.eyes.right)}}};
}

Json httpJson(const Status& status) {
    if (!status.httpRefused) return nullptr;
    Json refused = Json::object();
    for (const auto& [code, count] : *status.httpRefused)
        refused[std::to_string(code)] = count;
    return {{"refused", refused}};
}

std::string viewerText(const Json& viewer) {
    const Json &left = viewer.at("eyes_m").at(0), &right = viewer.at("eyes_m").at(1);
    const auto middle = [&](std::size_t axis) {
        return 0.5 * (left.at(axis).get<double>() + right.at(axis).get<double>());
    };
    char place[96];
    std::snprintf(place, sizeof place, " at %.2f, %.2f, %.2f m; samples ", middle(0), middle(1),
                  middle(2));
    return "viewer: " + viewer.at("source").get<std::string>() +
           (viewer.at("tracked").get<bool>() ? ", tracked" : ", not seen") + place +
           viewer.at("samples").dump() + '\n';
}

std::string sensorText(const char* name, const Json& sensor) {
    std::string text = std::string(name) + ": " + sensor.at("state").get<std::string>();
    if (const Json& age = sensor.at("last_frame_ms_ago"); age.is_number())
        text += ", last frame " + std::to_string(age.get<long long>()) + " ms ago";
    if (const auto reason = sensor.at("reason").get<std::string>(); !reason.empty())
        text += " (last loss: " + reason + ')';
    return text + '\n';
}

std::string stagesText(const Json& stages) {
    std::string text;
    for (const auto& [name, times] : stages.items()) {
        if (!times.at("p50_ms").is_number()) continue;
        char number[32];
        std::snprintf(number, sizeof number, " %.1f ms", times.at("p50_ms").get<double>());
        text += (text.empty() ? "" : ", ") + name + number;
    }
    return text;
}

std::string shownText(const Json& all) {
    const auto message = all.at("message").get<std::string>();
    char text[128];
    std::snprintf(text, sizeof text, " for %.1f s, %.1f pictures/s",
                  all.at("shown_for_s").get<double>(), all.at("pictures_per_s").get<double>());
    return "shows: " + all.at("shown").get<std::string>() + text +
           (message.empty() ? "" : ", \"" + message + '"') + '\n';
}

std::string valueText(const Json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
}

} // namespace

const char* sensorStateName(devices::SensorState state) {
    switch (state) {
    case devices::SensorState::Starting:
        return "starting";
    case devices::SensorState::Streaming:
        return "streaming";
    case devices::SensorState::Lost:
        return "lost";
    case devices::SensorState::Ended:
        break;
    }
    return "ended";
}

std::string statusLine(const Status& status, const Report& report) {
    const Json line{{"ok", true},
                    {"shown", status.shown},
                    {"message", status.message},
                    {"shown_for_s", status.shownForS},
                    {"picture_age_s", status.pictureAgeS},
                    {"frame_age_ms", ageMs(status.capturedAt, status.now)},
                    {"pictures_per_s", status.rate},
                    {"panel",
                     {{"width", status.width},
                      {"height", status.height},
                      {"is", status.panel},
                      {"monitor_on", status.monitorOn}}},
                    {"input_problem", status.inputProblem},
                    {"sensors", sensorsJson(status)},
                    {"viewer", viewerJson(status)},
                    {"http", httpJson(status)},
                    {"settings",
                     {{"scale", numberOrAuto(status.scale)},
                      {"focus", numberOrAuto(status.focusM)},
                      {"method", status.method},
                      {"brightness", status.brightness},
                      {"mode", status.flat ? "2d" : "3d"}}},
                    {"report", Json::parse(reportText(report))}};
    return line.dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::string statusText(const std::string& line) try {
    const Json all = Json::parse(line);
    const Json &report = all.at("report"), &panel = all.at("panel");
    std::string text = shownText(all);
    text += "display: " + report.at("display").get<std::string>() + ", " +
            std::to_string(panel.at("width").get<int>()) + "x" +
            std::to_string(panel.at("height").get<int>()) + ' ' +
            panel.at("is").get<std::string>() + '\n';
    text += "input: " + report.at("input").get<std::string>();
    const auto problem = all.at("input_problem").get<std::string>();
    text += (problem.empty() ? "" : " (not there: " + problem + ')') + '\n';
    if (const Json& sensors = all.at("sensors"); sensors.is_object())
        text += sensorText("depth", sensors.at("depth")) + sensorText("color", sensors.at("color"));
    if (const Json& viewer = all.at("viewer"); viewer.is_object()) text += viewerText(viewer);
    if (const Json& http = all.at("http"); http.is_object() && !http.at("refused").empty())
        text += "http: refused " + http.at("refused").dump() + '\n';
    text += "method: " + report.at("method").get<std::string>() + "; " +
            stagesText(report.at("stages")) + '\n';
    text += "frames: " + report.at("frames_in").dump() + " in, " +
            report.at("frames_presented").dump() + " presented, " +
            report.at("frames_skipped").dump() + " skipped " + report.at("skipped").dump() + ", " +
            report.at("frames_dropped").dump() + " dropped\n";
    if (const auto way = report.at("color_way").get<std::string>(); way != "copied")
        text += "color: " + way + ", without a copy\n";
    if (const Json& kept = report.at("search_kept_share"); kept.is_number())
        text += "not searched anew: " + std::to_string(static_cast<int>(100 * kept.get<double>())) +
                " % of the panel\n";
    if (const Json& kept = report.at("picture_kept_share"); kept.is_number())
        text += "not drawn anew: " + std::to_string(static_cast<int>(100 * kept.get<double>())) +
                " % of the panel\n";
    text += "settings:";
    for (const auto& [name, value] : all.at("settings").items())
        text += ' ' + name + '=' + valueText(value);
    return text + '\n';
} catch (const Json::exception& error) {
    throw std::runtime_error(std::string("control: an answer that is no status: ") + error.what());
}

} // namespace autostereo::daemon

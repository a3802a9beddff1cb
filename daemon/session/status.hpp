#pragma once

#include "config/config.hpp"
#include "daemon/session/report.hpp"
#include "daemon/session/viewer.hpp"
#include "devices/feed.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace autostereo::daemon {

/// What a running program shows, and why.
struct Status {
    std::string shown;                            ///< shownName's words, or "pattern"
    std::string message;                          ///< on the panel; empty: none
    double shownForS = 0;                         ///< seconds
    double pictureAgeS = 0;                       ///< since the panel was filled last
    std::optional<devices::TimePoint> capturedAt; ///< depth on the panel; none: no depth is shown
    double rate = 0;                              ///< live pictures per second, lately
    int width = 0, height = 0;                    ///< of the panel, pixels
    std::string panel;
    bool monitorOn = true;
    std::string inputProblem; ///< why the input is not there; empty: it is, or nothing is known
    std::optional<devices::SensorStatuses> sensors; ///< none: the input is not there
    devices::TimePoint now;
    std::string method;                  ///< as configured; the report has the one in use
    std::optional<double> focusM, scale; ///< as configured; none: auto
    double brightness = 1;
    bool flat = false;
    /// HTTP requests refused, by status; none: no page.
    std::optional<std::map<int, std::uint64_t>> httpRefused;
    std::optional<ViewerStatus> viewer; ///< none: nobody is followed
};

/// "starting", "streaming", "lost" or "ended".
[[nodiscard]] const char* sensorStateName(devices::SensorState state);

/// One JSON object in one line: {"ok": true, ..., "report": what --report writes}.
[[nodiscard]] std::string statusLine(const Status& status, const Report& report);
/// The same for people, some lines. Throws std::runtime_error where `line` is no such object.
[[nodiscard]] std::string statusText(const std::string& line);

} // namespace autostereo::daemon

#pragma once

#include "daemon/command_line.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <string_view>

// How options are read, for every command's list of them.

namespace autostereo::daemon {

template<class Words>
bool contains(const Words& words, std::string_view word) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

/// A word out of a table.
template<class Value>
auto oneOf(std::optional<Value>& to, const std::map<std::string, Value>& table,
           const char* option) {
    return [&to, &table, option](const std::string& word) {
        const auto found = table.find(word);
        if (found == table.end()) {
            std::string allowed;
            for (const auto& [name, value] : table)
                allowed += (allowed.empty() ? "" : ", ") + name;
            throw UsageError(std::string(option) + ": " + word + " is not known (allowed " +
                             allowed + ")");
        }
        to = found->second;
    };
}

inline auto vector3(std::optional<glm::dvec3>& to, const char* option) {
    return [&to, option](const std::vector<double>& numbers) {
        for (const double number : numbers)
            if (!std::isfinite(number))
                throw UsageError(std::string(option) + ": " + std::to_string(number) +
                                 " is not a length in metres");
        to = glm::dvec3{numbers[0], numbers[1], numbers[2]};
    };
}

/// Adds "interleave", "viewmap", "look", "pattern" and "import".
void addDisplayCommands(CLI::App& app, InterleaveOptions& interleave, ViewmapOptions& viewmap,
                        LookOptions& look, PatternOptions& pattern, ImportOptions& import);

/// Adds "latency".
void addLatency(CLI::App& app, LatencyOptions& latency);

/// Adds "status", "snapshot", "reload", "set" and "show".
void addControlCommands(CLI::App& app, ControlOptions& control);

/// Adds "calibrate" with what can be calibrated.
void addCalibrate(CLI::App& app, CalibrateNoiseOptions& noise, CalibrateCamerasOptions& cameras,
                  CalibrateRigOptions& rig, CalibrateTimingOptions& timing,
                  CalibrateDisplayOptions& display);

} // namespace autostereo::daemon

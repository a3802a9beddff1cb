#pragma once

#include "daemon/command_line.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <string_view>

// How options are read, for every command's list of them.

namespace autostereo::daemon {

template<class Words>
bool contains(const Words& words, std::string_view word) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

[[noreturn]] inline void notInThisVersion(const std::string& what) {
    throw UsageError(what + ": not in this version");
}

/// A word out of a table; words of later versions are told apart from nonsense.
template<class Value>
auto oneOf(std::optional<Value>& to, const std::map<std::string, Value>& table, const char* option,
           std::span<const char* const> later = {}) {
    return [&to, &table, option, later](const std::string& word) {
        if (contains(later, word)) notInThisVersion(std::string(option) + " " + word);
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

} // namespace autostereo::daemon

#pragma once

#include "devices/input.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

namespace autostereo::devices::mesh {

using Json = nlohmann::json;

inline constexpr std::size_t kMostEntries = 1'000'000; // of a list in the document

/// What a glTF file says, element by element, checked at every step. Errors are DeviceErrors that
/// name the key.
[[noreturn]] inline void failAt(const std::string& key, const Json& value,
                                const std::string& allowed) {
    constexpr std::size_t kMostShown = 40;
    // What is nested is not written out: that would be as deep as the file likes.
    const std::string shown = value.is_structured() ? value.type_name() : value.dump();
    throw DeviceError(key + " = '" + shown.substr(0, kMostShown) + "' (allowed " + allowed + ")");
}

/// A member, or nullptr where there is none.
[[nodiscard]] inline const Json* member(const Json& object, const char* key) {
    if (!object.is_object()) return nullptr;
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
}

/// A whole number below `end`, or `absent` where there is none.
[[nodiscard]] inline std::size_t whole(const Json& object, const char* key, std::size_t end,
                                       std::size_t absent) {
    const Json* value = member(object, key);
    if (value == nullptr) return absent;
    if (!value->is_number_integer() || *value < 0 || value->get<std::uint64_t>() >= end)
        failAt(key, *value, "whole numbers below " + std::to_string(end));
    return value->get<std::size_t>();
}
/// The same, where there has to be one.
[[nodiscard]] inline std::size_t whole(const Json& object, const char* key, std::size_t end) {
    if (member(object, key) == nullptr) throw DeviceError(std::string(key) + " is missing");
    return whole(object, key, end, 0);
}

/// A number, or `absent` where there is none or it is not finite.
[[nodiscard]] inline double number(const Json& object, const char* key, double absent) {
    const Json* value = member(object, key);
    if (value == nullptr) return absent;
    if (!value->is_number()) failAt(key, *value, "a number");
    const auto given = value->get<double>();
    return std::isfinite(given) ? given : absent;
}

/// The member's array, empty where there is none.
[[nodiscard]] inline const Json& list(const Json& object, const char* key, std::size_t most) {
    static const Json none = Json::array();
    const Json* value = member(object, key);
    if (value == nullptr) return none;
    if (!value->is_array() || value->size() > most)
        throw DeviceError(std::string(key) + " is no list of at most " + std::to_string(most));
    return *value;
}

[[nodiscard]] inline std::string text(const Json& object, const char* key) {
    const Json* value = member(object, key);
    if (value == nullptr) return {};
    if (!value->is_string()) failAt(key, *value, "text");
    return value->get<std::string>();
}

} // namespace autostereo::devices::mesh

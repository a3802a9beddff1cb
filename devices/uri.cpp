#include "devices/uri.hpp"

#include "devices/input.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <sstream>

namespace autostereo::devices {

namespace {

bool isSchemeLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }

void parseQuery(const std::string& text, Uri& uri) {
    std::istringstream fields(text);
    for (std::string field; std::getline(fields, field, '&');) {
        const auto equals = field.find('=');
        const std::string key = field.substr(0, equals);
        std::string wrong;
        if (key.empty() || equals == std::string::npos)
            wrong.append("'").append(field).append("' is no key=value");
        else if (!uri.query.emplace(key, field.substr(equals + 1)).second)
            wrong.append(key).append(" is given twice");
        if (!wrong.empty()) throw AddressError(uri.text + ": " + wrong);
    }
}

} // namespace

Uri parseUri(const std::string& text) {
    Uri uri;
    uri.text = text;
    const auto colon = std::find_if_not(text.begin(), text.end(), isSchemeLetter);
    if (colon == text.begin() || colon == text.end() || *colon != ':') {
        uri.path = text;
        return uri;
    }
    uri.scheme.assign(text.begin(), colon);
    const std::string rest(colon + 1, text.end());
    const auto mark = rest.find('?');
    uri.path = rest.substr(0, mark);
    if (mark != std::string::npos) parseQuery(rest.substr(mark + 1), uri);
    return uri;
}

void Uri::allowOnly(std::initializer_list<std::string_view> allowed) const {
    for (const auto& entry : query) {
        if (std::find(allowed.begin(), allowed.end(), entry.first) != allowed.end()) continue;
        std::string names;
        for (const std::string_view name : allowed) {
            if (!names.empty()) names += ", ";
            names += name;
        }
        throw AddressError(text + ": unknown key " + entry.first + " (allowed " +
                           (names.empty() ? "none" : names) + ")");
    }
}

double Uri::number(const std::string& key, double fallback, double lowest, double highest) const {
    const auto found = query.find(key);
    if (found == query.end()) return fallback;
    const std::string& digits = found->second;
    double result = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), result);
    if (error == std::errc{} && end == digits.data() + digits.size() && result >= lowest &&
        result <= highest)
        return result;
    char range[64];
    std::snprintf(range, sizeof range, "%g to %g", lowest, highest);
    throw AddressError(text + ": " + key + " = '" + digits + "' (allowed " + range + ")");
}

std::string Uri::value(const std::string& key) const {
    const auto found = query.find(key);
    return found == query.end() ? std::string{} : found->second;
}

} // namespace autostereo::devices

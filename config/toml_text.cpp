#include "config/toml_text.hpp"

#include <charconv>
#include <cstdio>

namespace autostereo::config {

namespace {

std::string digits(double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

std::string tomlString(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f) {
            std::array<char, 8> escape{};
            std::snprintf(escape.data(), escape.size(), "\\u%04X", static_cast<unsigned>(byte));
            out += escape.data();
        } else {
            if (c == '"' || c == '\\') out += '\\';
            out += c;
        }
    }
    return out + '"';
}

} // namespace

void TomlText::comment(std::string_view line) { text_.append("# ").append(line) += '\n'; }

void TomlText::table(std::string_view name) { text_.append("\n[").append(name).append("]\n"); }

void TomlText::line(std::string_view key, std::string_view value) {
    text_.append(key).append(" = ").append(value) += '\n';
}

void TomlText::text(std::string_view key, std::string_view value) { line(key, tomlString(value)); }

void TomlText::number(std::string_view key, double value) { line(key, digits(value)); }

void TomlText::integer(std::string_view key, int value) { line(key, std::to_string(value)); }

void TomlText::boolean(std::string_view key, bool value) { line(key, value ? "true" : "false"); }

void TomlText::numbers(std::string_view key, const std::vector<double>& values) {
    std::string list;
    for (const double value : values)
        list += (list.empty() ? "" : ", ") + digits(value);
    line(key, '[' + list + ']');
}

void TomlText::words(std::string_view key, const std::vector<std::string>& values) {
    std::string list;
    for (const std::string& value : values)
        list += "\n    " + tomlString(value) + ',';
    line(key, '[' + list + (list.empty() ? "]" : "\n]"));
}

void TomlText::rows(std::string_view key, const std::vector<std::vector<double>>& rows) {
    std::string list;
    for (const auto& row : rows) {
        std::string numbers;
        for (const double value : row)
            numbers += (numbers.empty() ? "" : ", ") + digits(value);
        list += "\n    [" + numbers + "],";
    }
    line(key, '[' + list + (list.empty() ? "]" : "\n]"));
}

void TomlText::texts(const std::map<std::string, std::string>& values) {
    for (const auto& [key, value] : values)
        text(tomlString(key), value);
}

} // namespace autostereo::config

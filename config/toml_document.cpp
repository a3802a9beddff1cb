#include "config/toml_document.hpp"

#include "config/load.hpp"
#include "config/phrases.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace autostereo::config {

namespace {

std::string_view typeName(const toml::node& node) {
    switch (node.type()) {
    case toml::node_type::table:
        return "a table";
    case toml::node_type::array:
        return "an array";
    case toml::node_type::string:
        return "a string";
    case toml::node_type::integer:
        return "an integer";
    case toml::node_type::floating_point:
        return "a floating-point number";
    case toml::node_type::boolean:
        return "a boolean";
    case toml::node_type::date:
        return "a date";
    case toml::node_type::time:
        return "a time";
    case toml::node_type::date_time:
        return "a date-time";
    default:
        return "nothing";
    }
}

[[noreturn]] void fail(const std::string& file, const toml::source_region& place,
                       const std::string& message) {
    throw ConfigError(oneLine((place.path ? *place.path : file) + ':' +
                              std::to_string(place.begin.line) + ':' +
                              std::to_string(place.begin.column) + ": " + message));
}

toml::table parsed(const std::string& file, std::string_view text) {
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        fail(file, error.source(), "syntax: " + std::string(error.description()));
    }
}

void merge(toml::table& into, const toml::table& base) {
    for (const auto& [key, node] : base) {
        toml::node* own = into.get(key);
        if (own == nullptr)
            node.visit([&, name = key](const auto& value) { into.insert(name, value); });
        else if (own->is_table() && node.is_table())
            merge(*own->as_table(), *node.as_table());
    }
}

} // namespace

std::string joined(const std::string& path, std::string_view key) {
    return path.empty() ? std::string(key) : path + '.' + std::string(key);
}

TomlReader::Document::Document(std::string name, std::string_view text, Fallbacks allowed)
    : file(std::move(name)), fallbacks(allowed), root(parsed(file, text)) {}

void TomlReader::Document::inherit(const Document& base) { merge(root, base.root); }

const toml::table* TomlReader::Document::tableAt(const std::string& path) const {
    return path.empty() ? &root : root.at_path(path).as_table();
}

const toml::node* TomlReader::Document::find(const std::string& path, std::string_view key) const {
    const toml::table* table = tableAt(path);
    return table == nullptr ? nullptr : table->get(key);
}

toml::source_region TomlReader::Document::placeAround(std::string path) const {
    while (!path.empty() && tableAt(path) == nullptr)
        path.resize(path.find('.') == std::string::npos ? 0 : path.rfind('.'));
    return tableAt(path)->source();
}

void TomlReader::Document::note(bool missing, const toml::source_region& place,
                                const std::string& key, const std::string& what) {
    problems.try_emplace(key, Problem{missing, place, what});
}

void TomlReader::Document::noteType(const toml::node& node, const std::string& key,
                                    const std::string& wanted) {
    note(false, node.source(), key, "is " + std::string(typeName(node)) + ", wanted " + wanted);
}

const toml::node* TomlReader::Document::ask(const std::string& path, std::string_view key,
                                            bool hasFallback, const std::string& wanted) {
    const toml::node* node = find(path, key);
    asked.emplace(tableAt(path), key);
    if (node == nullptr && (!hasFallback || fallbacks == Fallbacks::Refused))
        note(true, placeAround(path), joined(path, key), "missing, wanted " + wanted);
    return node;
}

std::optional<double> TomlReader::Document::number(const toml::node& node, const std::string& key,
                                                   Range range, const std::string& wanted) {
    if (!node.is_number()) {
        noteType(node, key, wanted);
        return std::nullopt;
    }
    const double value =
        node.is_integer() ? static_cast<double>(**node.as_integer()) : **node.as_floating_point();
    if (value >= range.low && value <= range.high) return value;
    note(false, node.source(), key,
         plain(value) + (std::isfinite(value) ? " is out of range " : " is no finite number ") +
             allowed(range));
    return std::nullopt;
}

const toml::array* TomlReader::Document::arrayAt(const std::string& path, std::string_view key,
                                                 Range count, const std::string& wanted,
                                                 bool hasFallback) {
    const std::string full = joined(path, key);
    const toml::node* node = ask(path, key, hasFallback, wanted);
    if (node == nullptr) return nullptr;
    const toml::array* array = node->as_array();
    if (array == nullptr) {
        noteType(*node, full, wanted);
        return nullptr;
    }
    const auto size = static_cast<double>(array->size());
    if (size >= count.low && size <= count.high) return array;
    note(false, node->source(), full,
         "has " + std::to_string(array->size()) + " elements, wanted " + wanted);
    return nullptr;
}

std::vector<double> TomlReader::Document::numbersOf(const toml::array& array,
                                                    const std::string& full, Range range) {
    std::vector<double> values;
    for (const toml::node& element : array) {
        const auto value = number(element, full, range, "a number " + allowed(range));
        values.push_back(value.value_or(range.low));
    }
    return values;
}

void TomlReader::Document::noteUnknown(const toml::table& table, const std::string& path) {
    std::vector<std::string_view> known;
    for (const auto& [owner, name] : asked)
        if (owner == &table) known.push_back(name);
    for (const auto& [key, node] : table) {
        const std::string full = joined(path, key.str());
        const toml::table* inner = node.as_table();
        if (asked.contains({&table, std::string(key.str())})) {
            if (inner != nullptr) noteUnknown(*inner, full);
            continue;
        }
        const auto near = nearestWord(key.str(), known);
        note(false, key.source(), full,
             "unknown key" + (near.empty() ? "" : " (did you mean " + std::string(near) + "?)"));
    }
}

void TomlReader::Document::check() const {
    if (problems.empty()) return;
    // A file's own problems before those of the file that it builds on.
    const auto rank = [this](const auto& entry) {
        const Problem& problem = entry.second;
        const bool foreign = problem.place.path && *problem.place.path != file;
        return std::tuple(problem.missing, foreign, problem.place.begin.line,
                          problem.place.begin.column);
    };
    const auto& [key, problem] =
        *std::min_element(problems.begin(), problems.end(),
                          [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    fail(file, problem.place, key + ": " + problem.what);
}

} // namespace autostereo::config

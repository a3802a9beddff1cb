#include "config/toml_reader.hpp"

#include "config/load.hpp"
#include "config/phrases.hpp"

#include <toml++/toml.h>

#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace autostereo::config {

namespace {

struct Problem {
    bool missing; ///< reported last: a misspelt key is unknown and missing at once
    toml::source_position place;
    std::string what;

    [[nodiscard]] auto rank() const { return std::tie(missing, place.line, place.column); }
};

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

std::string joined(const std::string& path, std::string_view key) {
    return path.empty() ? std::string(key) : path + '.' + std::string(key);
}

[[noreturn]] void fail(const std::string& file, const toml::source_position& place,
                       const std::string& message) {
    throw ConfigError(oneLine(file + ':' + std::to_string(place.line) + ':' +
                              std::to_string(place.column) + ": " + message));
}

toml::table parsed(const std::string& file, std::string_view text) {
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        fail(file, error.source().begin, "syntax: " + std::string(error.description()));
    }
}

} // namespace

/// The parsed text, what was asked of it and what was found wrong.
struct TomlReader::Document {
    std::string file;
    Fallbacks fallbacks;
    toml::table root;
    std::set<std::pair<const toml::table*, std::string>> asked;
    std::map<std::string, Problem> problems; ///< by key; the first complaint stands

    [[nodiscard]] const toml::table* tableAt(const std::string& path) const {
        return path.empty() ? &root : root.at_path(path).as_table();
    }
    [[nodiscard]] const toml::node* find(const std::string& path, std::string_view key) const {
        const toml::table* table = tableAt(path);
        return table == nullptr ? nullptr : table->get(key);
    }

    /// Where a reader looks for a key: the nearest table around it that exists.
    [[nodiscard]] toml::source_position placeAround(std::string path) const {
        while (!path.empty() && tableAt(path) == nullptr)
            path.resize(path.find('.') == std::string::npos ? 0 : path.rfind('.'));
        return tableAt(path)->source().begin;
    }

    void note(bool missing, toml::source_position place, const std::string& key,
              const std::string& what) {
        problems.try_emplace(key, Problem{missing, place, what});
    }

    void noteType(const toml::node& node, const std::string& key, const std::string& wanted) {
        note(false, node.source().begin, key,
             "is " + std::string(typeName(node)) + ", wanted " + wanted);
    }

    const toml::node* ask(const std::string& path, std::string_view key, bool hasFallback,
                          const std::string& wanted) {
        const toml::node* node = find(path, key);
        asked.emplace(tableAt(path), key);
        if (node == nullptr && (!hasFallback || fallbacks == Fallbacks::Refused))
            note(true, placeAround(path), joined(path, key), "missing, wanted " + wanted);
        return node;
    }

    std::optional<double> number(const toml::node& node, const std::string& key, Range range,
                                 const std::string& wanted) {
        if (!node.is_number()) {
            noteType(node, key, wanted);
            return std::nullopt;
        }
        const double value = node.is_integer() ? static_cast<double>(**node.as_integer())
                                               : **node.as_floating_point();
        if (value >= range.low && value <= range.high) return value;
        note(false, node.source().begin, key,
             plain(value) + (std::isfinite(value) ? " is out of range " : " is no finite number ") +
                 allowed(range));
        return std::nullopt;
    }

    [[nodiscard]] std::string suggestion(const toml::table& table, std::string_view key) const {
        std::vector<std::string_view> known;
        for (const auto& [owner, name] : asked)
            if (owner == &table) known.push_back(name);
        const auto near = nearestWord(key, known);
        return near.empty() ? "" : " (did you mean " + std::string(near) + "?)";
    }

    void noteUnknown(const toml::table& table, const std::string& path) {
        for (const auto& [key, node] : table) {
            const std::string full = joined(path, key.str());
            if (!asked.contains({&table, std::string(key.str())}))
                note(false, key.source().begin, full, "unknown key" + suggestion(table, key.str()));
            else if (const toml::table* inner = node.as_table())
                noteUnknown(*inner, full);
        }
    }
};

TomlReader::TomlReader(const std::string& file, std::string_view text, Fallbacks fallbacks)
    : owned_(new Document{file, fallbacks, parsed(file, text), {}, {}}), document_(owned_.get()) {}

TomlReader::TomlReader(Document& document, std::string path)
    : document_(&document), path_(std::move(path)) {}

TomlReader::~TomlReader() = default;

bool TomlReader::has(std::string_view key) const { return document_->find(path_, key) != nullptr; }

TomlReader TomlReader::table(std::string_view key) {
    const toml::node* node = document_->ask(path_, key, true, "a table");
    if (node != nullptr && !node->is_table())
        document_->noteType(*node, joined(path_, key), "a table");
    return {*document_, joined(path_, key)};
}

bool TomlReader::boolean(std::string_view key) {
    const std::string wanted = "true or false";
    const toml::node* node = document_->ask(path_, key, false, wanted);
    if (node == nullptr) return false;
    if (!node->is_boolean()) document_->noteType(*node, joined(path_, key), wanted);
    return node->value_or(false);
}

int TomlReader::integer(std::string_view key, Range range, std::optional<int> fallback) {
    const std::string wanted = "an integer " + allowed(range);
    const std::string full = joined(path_, key);
    const int otherwise = fallback.value_or(static_cast<int>(range.low));
    const toml::node* node = document_->ask(path_, key, fallback.has_value(), wanted);
    if (node == nullptr) return otherwise;
    if (node->is_floating_point()) {
        document_->noteType(*node, full, wanted);
        return otherwise;
    }
    return static_cast<int>(document_->number(*node, full, range, wanted).value_or(otherwise));
}

double TomlReader::number(std::string_view key, Range range, std::optional<double> fallback) {
    const std::string wanted = "a number " + allowed(range);
    const double otherwise = fallback.value_or(range.low);
    const toml::node* node = document_->ask(path_, key, fallback.has_value(), wanted);
    if (node == nullptr) return otherwise;
    return document_->number(*node, joined(path_, key), range, wanted).value_or(otherwise);
}

std::string TomlReader::text(std::string_view key, const std::optional<std::string>& fallback) {
    const std::string wanted = "a string";
    const toml::node* node = document_->ask(path_, key, fallback.has_value(), wanted);
    if (node == nullptr) return fallback.value_or("");
    if (!node->is_string()) document_->noteType(*node, joined(path_, key), wanted);
    return node->value_or(std::string());
}

std::optional<double> TomlReader::numberOrAuto(std::string_view key, Range range,
                                               std::optional<double> fallback) {
    const std::string wanted = "\"auto\" or a number " + allowed(range);
    const toml::node* node = document_->ask(path_, key, true, wanted);
    if (node == nullptr) return fallback;
    if (node->value<std::string_view>() == "auto") return std::nullopt;
    return document_->number(*node, joined(path_, key), range, wanted);
}

std::optional<std::string> TomlReader::textOrAuto(std::string_view key,
                                                  const std::optional<std::string>& fallback) {
    const std::string value = text(key, fallback.value_or("auto"));
    return value == "auto" ? std::nullopt : std::optional(value);
}

std::vector<double> TomlReader::numberList(std::string_view key, std::size_t count, Range range,
                                           bool hasFallback) {
    const std::string wanted =
        "an array of " + std::to_string(count) + " numbers " + allowed(range);
    const std::string full = joined(path_, key);
    const toml::node* node = document_->ask(path_, key, hasFallback, wanted);
    if (node == nullptr) return {};
    const toml::array* array = node->as_array();
    if (array == nullptr) {
        document_->noteType(*node, full, wanted);
        return {};
    }
    if (array->size() != count)
        document_->note(false, node->source().begin, full,
                        "has " + std::to_string(array->size()) + " elements, wanted " + wanted);
    std::vector<double> values;
    for (const toml::node& element : *array) {
        const auto value = document_->number(element, full, range, "a number " + allowed(range));
        values.push_back(value.value_or(range.low));
    }
    return values;
}

std::optional<std::size_t> TomlReader::wordIndex(std::string_view key,
                                                 const std::vector<std::string_view>& words,
                                                 bool hasFallback) {
    const std::string wanted = "a word " + allowed(words);
    const toml::node* node = document_->ask(path_, key, hasFallback, wanted);
    if (node == nullptr) return std::nullopt;
    if (!node->is_string()) {
        document_->noteType(*node, joined(path_, key), wanted);
        return std::nullopt;
    }
    const auto value = node->value_or(std::string_view());
    const auto found = std::find(words.begin(), words.end(), value);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    document_->note(false, node->source().begin, joined(path_, key),
                    '"' + std::string(value) + "\" is unknown " + allowed(words));
    return std::nullopt;
}

void TomlReader::reject(std::string_view key, const std::string& what) {
    const toml::node* node = document_->find(path_, key);
    const auto place = node == nullptr ? document_->placeAround(path_) : node->source().begin;
    document_->note(false, place, joined(path_, key), what);
}

void TomlReader::check() const {
    const auto& problems = document_->problems;
    if (problems.empty()) return;
    const auto& [key, problem] =
        *std::min_element(problems.begin(), problems.end(), [](const auto& a, const auto& b) {
            return a.second.rank() < b.second.rank();
        });
    fail(document_->file, problem.place, key + ": " + problem.what);
}

void TomlReader::finish() {
    document_->noteUnknown(document_->root, "");
    check();
}

} // namespace autostereo::config

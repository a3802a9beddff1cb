#include "config/toml_reader.hpp"

#include "config/phrases.hpp"
#include "config/toml_document.hpp"

#include <algorithm>

namespace autostereo::config {

namespace {

std::string counted(Range count) {
    return count.low == count.high ? plain(count.low)
                                   : plain(count.low) + " to " + plain(count.high);
}

} // namespace

TomlReader::TomlReader(const std::string& file, std::string_view text, Fallbacks fallbacks)
    : owned_(new Document(file, text, fallbacks)), document_(owned_.get()) {}

TomlReader::TomlReader(Document& document, std::string path)
    : document_(&document), path_(std::move(path)) {}

TomlReader::~TomlReader() = default;

void TomlReader::inherit(const std::string& file, std::string_view text) {
    document_->inherit(Document(file, text, document_->fallbacks));
}

bool TomlReader::has(std::string_view key) const { return document_->find(path_, key) != nullptr; }

TomlReader TomlReader::table(std::string_view key) {
    const toml::node* node = document_->ask(path_, key, true, "a table");
    if (node != nullptr && !node->is_table())
        document_->noteType(*node, joined(path_, key), "a table");
    return {*document_, joined(path_, key)};
}

bool TomlReader::boolean(std::string_view key, std::optional<bool> fallback) {
    const std::string wanted = "true or false";
    const toml::node* node = document_->ask(path_, key, fallback.has_value(), wanted);
    if (node == nullptr) return fallback.value_or(false);
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

std::vector<double> TomlReader::numberList(std::string_view key, Range count, Range range,
                                           bool hasFallback) {
    const std::string wanted = "an array of " + counted(count) + " numbers " + allowed(range);
    const toml::array* array = document_->arrayAt(path_, key, count, wanted, hasFallback);
    return array == nullptr ? std::vector<double>{}
                            : document_->numbersOf(*array, joined(path_, key), range);
}

std::vector<std::vector<double>> TomlReader::numberRows(std::string_view key, Range rows,
                                                        Range columns, Range range) {
    const std::string full = joined(path_, key);
    const std::string wanted = "an array of " + counted(rows) + " rows of " + counted(columns) +
                               " numbers " + allowed(range);
    const toml::array* array = document_->arrayAt(path_, key, rows, wanted, false);
    std::vector<std::vector<double>> table;
    if (array == nullptr) return table;
    for (const toml::node& element : *array) {
        const toml::array* row = element.as_array();
        if (row == nullptr) {
            document_->noteType(element, full, wanted);
            return {};
        }
        const auto size = static_cast<double>(row->size());
        if (size < columns.low || size > columns.high ||
            (!table.empty() && row->size() != table.front().size())) {
            document_->note(false, element.source(), full,
                            "has a row of " + std::to_string(row->size()) +
                                " elements, wanted rows of equal length, " + counted(columns));
            return {};
        }
        table.push_back(document_->numbersOf(*row, full, range));
    }
    return table;
}

std::vector<std::string> TomlReader::words(std::string_view key, Range count) {
    const std::string wanted = "an array of " + counted(count) + " strings";
    std::vector<std::string> found;
    const toml::array* array = document_->arrayAt(path_, key, count, wanted, false);
    if (array == nullptr) return found;
    for (const toml::node& element : *array) {
        if (!element.is_string()) document_->noteType(element, joined(path_, key), wanted);
        found.push_back(element.value_or(std::string()));
    }
    return found;
}

std::map<std::string, std::string> TomlReader::texts() {
    std::map<std::string, std::string> found;
    const toml::table* table = document_->tableAt(path_);
    if (table == nullptr) return found;
    for (const auto& [key, node] : *table) {
        document_->ask(path_, key.str(), true, "a string");
        if (!node.is_string()) document_->noteType(node, joined(path_, key.str()), "a string");
        found.emplace(key.str(), node.value_or(std::string()));
    }
    return found;
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
    document_->note(false, node->source(), joined(path_, key),
                    '"' + std::string(value) + "\" is unknown " + allowed(words));
    return std::nullopt;
}

void TomlReader::reject(std::string_view key, const std::string& what) {
    const toml::node* node = document_->find(path_, key);
    const auto place = node == nullptr ? document_->placeAround(path_) : node->source();
    document_->note(false, place, joined(path_, key), what);
}

void TomlReader::check() const { document_->check(); }

void TomlReader::finish() {
    document_->noteUnknown(document_->root, "");
    check();
}

} // namespace autostereo::config

#include "config/json_fields.hpp"

#include "config/load.hpp"
#include "config/phrases.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <regex>
#include <set>

namespace autostereo::config {

namespace {

using nlohmann::json;

[[noreturn]] void fail(const std::string& file, const std::string& message) {
    throw ConfigError(oneLine(file + ": " + message));
}

/// nlohmann's own words, "[json.exception.parse_error.101] parse error at line 1, column 2: why",
/// as "file:1:2: is no JSON: why".
[[noreturn]] void failAsWritten(const std::string& file, const std::string& what) {
    const std::regex form(R"(\[[^\]]*\] (?:parse error at line (\d+), column (\d+): )?)");
    std::smatch match;
    std::regex_search(what, match, form, std::regex_constants::match_continuous);
    const std::string place = match[1].matched ? ':' + match.str(1) + ':' + match.str(2) : "";
    fail(file + place, "is no JSON: " + what.substr(static_cast<std::size_t>(match.length(0))));
}

json parsed(const std::string& file, std::string_view text) {
    constexpr std::size_t kLongest = 1 << 20;
    constexpr int kDeepest = 16;
    if (text.size() > kLongest) fail(file, "is longer than 1 MiB");
    const auto limited = [&file](int depth, json::parse_event_t, json&) {
        if (depth > kDeepest)
            fail(file, "is nested too deeply (allowed " + std::to_string(kDeepest) + " levels)");
        return true;
    };
    try {
        return json::parse(text, limited);
    } catch (const json::exception& error) {
        failAsWritten(file, error.what());
    }
}

/// The number itself or the one in {"value": ...}.
const json& unwrapped(const json& node) {
    return node.is_object() && node.contains("value") ? node.at("value") : node;
}

std::string typeName(const json& node) {
    if (node.is_number()) return "is a number";
    if (node.is_object()) return "is an object";
    if (node.is_array()) return "is an array";
    return "is " + std::string(node.is_null() ? "" : "a ") + node.type_name();
}

} // namespace

/// Members share the text, so that an inner object may outlive the outer one.
struct JsonFields::Node {
    std::string file;
    std::string path; ///< "" for the root, else "subpixelCells[0]."
    std::shared_ptr<const json> root;
    const json* object;
    std::set<std::string, std::less<>> asked;

    const json* ask(std::string_view key) {
        asked.emplace(key);
        return find(key);
    }
    [[nodiscard]] const json* find(std::string_view key) const {
        const auto found = object->find(key);
        return found == object->end() ? nullptr : &*found;
    }
    [[nodiscard]] std::unique_ptr<Node> inner(const json& value, const std::string& name) const {
        return std::make_unique<Node>(Node{file, path + name + '.', root, &value, {}});
    }
};

JsonFields::JsonFields(const std::string& file, std::string_view text) {
    auto root = std::make_shared<const json>(parsed(file, text));
    if (!root->is_object()) fail(file, typeName(*root) + ", wanted a JSON object");
    const json* object = root.get();
    node_ = std::make_unique<Node>(Node{file, "", std::move(root), object, {}});
}

JsonFields::JsonFields(std::unique_ptr<Node> node) : node_(std::move(node)) {}
JsonFields::JsonFields(JsonFields&&) noexcept = default;
JsonFields& JsonFields::operator=(JsonFields&&) noexcept = default;
JsonFields::~JsonFields() = default;

bool JsonFields::has(std::string_view key) const { return node_->find(key) != nullptr; }

std::optional<JsonFields> JsonFields::object(std::string_view key) {
    const json* found = node_->ask(key);
    if (found == nullptr || !found->is_object()) return std::nullopt;
    return JsonFields(node_->inner(*found, std::string(key)));
}

std::vector<JsonFields> JsonFields::objects(std::string_view key, Range count) {
    std::vector<JsonFields> found;
    const json* list = node_->ask(key);
    if (list == nullptr) return found;
    const std::string wanted =
        ", wanted an array of " + plain(count.low) + " to " + plain(count.high) + " objects";
    if (!list->is_array()) reject(key, typeName(*list) + wanted);
    const auto size = static_cast<double>(list->size());
    if (size < count.low || size > count.high)
        reject(key, "has " + plain(size) + " elements" + wanted);
    for (const json& element : *list) {
        const std::string name = std::string(key) + '[' + std::to_string(found.size()) + ']';
        if (!element.is_object()) reject(name, typeName(element) + ", wanted an object");
        found.push_back(JsonFields(node_->inner(element, name)));
    }
    return found;
}

double JsonFields::number(std::string_view key, Range range, std::optional<double> fallback) {
    const json* found = node_->ask(key);
    if (found == nullptr && fallback) return *fallback;
    if (found == nullptr) reject(key, "missing, wanted a number " + allowed(range));
    const json& value = unwrapped(*found);
    if (!value.is_number()) reject(key, typeName(value) + ", wanted a number " + allowed(range));
    const auto number = value.get<double>();
    if (!(number >= range.low && number <= range.high))
        reject(key, plain(number) + " is out of range " + allowed(range));
    return number;
}

int JsonFields::integer(std::string_view key, Range range, std::optional<int> fallback) {
    const double value =
        number(key, range, fallback ? std::optional<double>(*fallback) : std::nullopt);
    if (value != std::floor(value))
        reject(key, plain(value) + " is no whole number " + allowed(range));
    return static_cast<int>(value);
}

bool JsonFields::flag(std::string_view key, std::optional<bool> fallback) {
    if (const json* found = node_->ask(key); found != nullptr && unwrapped(*found).is_boolean())
        return unwrapped(*found).get<bool>();
    constexpr double kSet = 0.5;
    return number(key, {0, 1}, fallback ? std::optional(*fallback ? 1.0 : 0.0) : std::nullopt) >=
           kSet;
}

std::string JsonFields::text(std::string_view key) {
    const json* found = node_->ask(key);
    if (found == nullptr) return "";
    const json& value = unwrapped(*found);
    if (!value.is_string()) reject(key, typeName(value) + ", wanted a string");
    return value.get<std::string>();
}

std::optional<double> JsonFields::anyNumber(std::string_view key) const {
    const json* found = node_->find(key);
    if (found == nullptr || !unwrapped(*found).is_number()) return std::nullopt;
    return unwrapped(*found).get<double>();
}

std::map<std::string, std::string> JsonFields::rest() const {
    constexpr std::size_t kMost = 64, kLongest = 200;
    std::map<std::string, std::string> texts;
    for (const auto& [key, value] : node_->object->items()) {
        if (node_->asked.contains(key) || texts.size() == kMost) continue;
        // ASCII only, so that the cut cannot split a letter.
        std::string text = unwrapped(value).dump(-1, ' ', true);
        if (unwrapped(value).is_string()) text = text.substr(1, text.size() - 2);
        texts.emplace(key, text.size() > kLongest ? text.substr(0, kLongest) + "..." : text);
    }
    return texts;
}

void JsonFields::reject(std::string_view key, const std::string& what) const {
    fail(node_->file, node_->path + std::string(key) + ": " + what);
}

} // namespace autostereo::config

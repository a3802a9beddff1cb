#pragma once

#include "config/toml_reader.hpp"

#include <toml++/toml.h>

#include <map>
#include <set>
#include <string>
#include <utility>

namespace autostereo::config {

/// The parsed text behind a TomlReader, what was asked of it and what was found wrong.
struct TomlReader::Document {
    struct Problem {
        bool missing; ///< reported last: a misspelt key is unknown and missing at once
        toml::source_region place;
        std::string what;
    };

    /// Throws ConfigError where `text` is no TOML.
    Document(std::string name, std::string_view text, Fallbacks allowed);

    /// Takes over what `base` says and this text does not.
    void inherit(const Document& base);

    [[nodiscard]] const toml::table* tableAt(const std::string& path) const;
    [[nodiscard]] const toml::node* find(const std::string& path, std::string_view key) const;
    /// Where a reader looks for a key: the nearest table around it that exists.
    [[nodiscard]] toml::source_region placeAround(std::string path) const;

    void note(bool missing, const toml::source_region& place, const std::string& key,
              const std::string& what);
    void noteType(const toml::node& node, const std::string& key, const std::string& wanted);
    const toml::node* ask(const std::string& path, std::string_view key, bool hasFallback,
                          const std::string& wanted);
    /// The number if it is one in the range, else nothing and a note.
    std::optional<double> number(const toml::node& node, const std::string& key, Range range,
                                 const std::string& wanted);
    /// The array if it has so many elements, else null and a note.
    const toml::array* arrayAt(const std::string& path, std::string_view key, Range count,
                               const std::string& wanted, bool hasFallback);
    std::vector<double> numbersOf(const toml::array& array, const std::string& full, Range range);
    void noteUnknown(const toml::table& table, const std::string& path);
    /// Throws the first problem, if any.
    void check() const;

    std::string file;
    Fallbacks fallbacks;
    toml::table root;
    std::set<std::pair<const toml::table*, std::string>> asked;
    std::map<std::string, Problem> problems; ///< by key; the first complaint stands
};

/// "a.b" of a table's path and a key in it.
[[nodiscard]] std::string joined(const std::string& path, std::string_view key);

} // namespace autostereo::config

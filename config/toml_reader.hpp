#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace autostereo::config {

/// Both ends allowed.
struct Range {
    double low;
    double high;
};

/// One table of a TOML text, read key by key, so that a loader is a list of keys with their ranges.
/// A getter without a fallback requires its key. What is wrong is noted with its place and answered
/// with some allowed value; `finish` throws the first of it as ConfigError, unknown keys included,
/// and those before missing ones, because a misspelt key is both. Absent tables read as empty.
/// The root owns the text; tables taken from it must not outlive it. Thread-bound.
class TomlReader {
  public:
    /// Whether fallbacks count: the shipped default.toml has to give every key.
    enum class Fallbacks { Allowed, Refused };

    /// Throws ConfigError where `text` is no TOML; `file` is its name in messages.
    TomlReader(const std::string& file, std::string_view text,
               Fallbacks fallbacks = Fallbacks::Allowed);
    ~TomlReader();
    TomlReader(const TomlReader&) = delete;
    TomlReader& operator=(const TomlReader&) = delete;

    /// A text that this one builds on: gives whatever keys are not given here. Root only, before
    /// any key is read; throws like the constructor.
    void inherit(const std::string& file, std::string_view text);

    [[nodiscard]] bool has(std::string_view key) const;
    [[nodiscard]] TomlReader table(std::string_view key);

    [[nodiscard]] bool boolean(std::string_view key, std::optional<bool> fallback = std::nullopt);
    [[nodiscard]] int integer(std::string_view key, Range range,
                              std::optional<int> fallback = std::nullopt);
    [[nodiscard]] double number(std::string_view key, Range range,
                                std::optional<double> fallback = std::nullopt);
    [[nodiscard]] std::string text(std::string_view key,
                                   const std::optional<std::string>& fallback = std::nullopt);
    /// The word "auto" reads as nothing.
    [[nodiscard]] std::optional<double> numberOrAuto(std::string_view key, Range range,
                                                     std::optional<double> fallback);
    [[nodiscard]] std::optional<std::string> textOrAuto(std::string_view key,
                                                        const std::optional<std::string>& fallback);

    template<std::size_t N>
    [[nodiscard]] std::array<double, N>
    numbers(std::string_view key, Range range,
            const std::optional<std::array<double, N>>& fallback = std::nullopt) {
        std::array<double, N> values = fallback.value_or(std::array<double, N>{});
        if (const auto list = numberList(key, {N, N}, range, fallback.has_value());
            list.size() == N)
            std::copy(list.begin(), list.end(), values.begin());
        return values;
    }

    /// So many numbers, each in the range; empty where absent with `hasFallback`, or wrong.
    [[nodiscard]] std::vector<double> numberList(std::string_view key, Range count, Range range,
                                                 bool hasFallback = false);
    /// Rows of equal length.
    [[nodiscard]] std::vector<std::vector<double>> numberRows(std::string_view key, Range rows,
                                                              Range columns, Range range);
    /// So many strings.
    [[nodiscard]] std::vector<std::string> words(std::string_view key, Range count);
    /// All keys of this table, whatever they are called; each has to be a string.
    [[nodiscard]] std::map<std::string, std::string> texts();

    /// One of a few words, each with what it stands for.
    template<class Value>
    [[nodiscard]] Value choice(std::string_view key,
                               std::span<const std::pair<std::string_view, Value>> allowed,
                               const std::optional<Value>& fallback = std::nullopt) {
        std::vector<std::string_view> words;
        for (const auto& entry : allowed)
            words.push_back(entry.first);
        if (const auto index = wordIndex(key, words, fallback.has_value()))
            return allowed[*index].second;
        return fallback.value_or(allowed.front().second);
    }
    template<class Value>
    [[nodiscard]] Value choice(std::string_view key,
                               std::initializer_list<std::pair<std::string_view, Value>> allowed,
                               const std::optional<Value>& fallback = std::nullopt) {
        return choice<Value>(key, std::span(allowed.begin(), allowed.size()), fallback);
    }

    /// The place of the key's word in a list, for lists that are not known beforehand.
    [[nodiscard]] std::optional<std::size_t> wordIndex(std::string_view key,
                                                       const std::vector<std::string_view>& words,
                                                       bool hasFallback = false);

    /// Notes that a key's value is wrong for a reason that spans keys. Only the first complaint
    /// about a key counts.
    void reject(std::string_view key, const std::string& what);

    /// Throws what was noted so far, if anything.
    void check() const;
    /// Adds the keys of the whole text that no getter asked for, then `check`.
    void finish();

    struct Document;

  private:
    TomlReader(Document& document, std::string path);

    std::unique_ptr<Document> owned_; ///< the root's; empty in other tables
    Document* document_;
    std::string path_; ///< "" for the root
};

} // namespace autostereo::config

#pragma once

#include "config/toml_reader.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace autostereo::config {

/// One object of a JSON text from outside, read key by key as TomlReader reads tables. Numbers may
/// be wrapped: {"value": 5}. The first thing that is wrong is thrown as ConfigError, one line:
/// `file: key: what is wrong (allowed ...)`. Takes any bytes; texts of more than 1 MiB or nested
/// deeper than 16 are refused. Thread-bound.
class JsonFields {
  public:
    /// Throws ConfigError where `text` is no JSON object; `file` is its name in messages.
    JsonFields(const std::string& file, std::string_view text);
    ~JsonFields();
    JsonFields(JsonFields&&) noexcept;
    JsonFields& operator=(JsonFields&&) noexcept;

    [[nodiscard]] bool has(std::string_view key) const;
    /// The object there; nothing where there is none.
    [[nodiscard]] std::optional<JsonFields> object(std::string_view key);
    /// The objects of an array; none where the key is absent.
    [[nodiscard]] std::vector<JsonFields> objects(std::string_view key, Range count);

    [[nodiscard]] double number(std::string_view key, Range range,
                                std::optional<double> fallback = std::nullopt);
    [[nodiscard]] int integer(std::string_view key, Range range,
                              std::optional<int> fallback = std::nullopt);
    /// 0 or 1, or what lies between: from 0.5 on it is set.
    [[nodiscard]] bool flag(std::string_view key, std::optional<bool> fallback = std::nullopt);
    [[nodiscard]] std::string text(std::string_view key);
    /// A number, whatever its value, for a look before the ranges; nothing where there is none.
    [[nodiscard]] std::optional<double> anyNumber(std::string_view key) const;

    /// What no getter asked for, as JSON of at most 200 characters (texts without their quotes); at
    /// most 64 keys.
    [[nodiscard]] std::map<std::string, std::string> rest() const;

    [[noreturn]] void reject(std::string_view key, const std::string& what) const;

  private:
    struct Node;
    explicit JsonFields(std::unique_ptr<Node> node);

    std::unique_ptr<Node> node_;
};

} // namespace autostereo::config

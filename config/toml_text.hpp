#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace autostereo::config {

/// A TOML text being written, line by line; what it holds reads back to the same values.
class TomlText {
  public:
    void comment(std::string_view line);
    void table(std::string_view name);

    void text(std::string_view key, std::string_view value);
    /// The shortest digits that read back to the same double.
    void number(std::string_view key, double value);
    void integer(std::string_view key, int value);
    void boolean(std::string_view key, bool value);
    void numbers(std::string_view key, const std::vector<double>& values);
    void words(std::string_view key, const std::vector<std::string>& values);
    void rows(std::string_view key, const std::vector<std::vector<double>>& rows);
    /// Keys of any letters.
    void texts(const std::map<std::string, std::string>& values);

    [[nodiscard]] const std::string& str() const { return text_; }

  private:
    void line(std::string_view key, std::string_view value);

    std::string text_;
};

} // namespace autostereo::config

#pragma once

#include "devices/input.hpp"

#include <charconv>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace autostereo::devices::mesh {

/// Walks over a text file's lines and the words in them, without copies. Reentrant.
class TextLines {
  public:
    TextLines(std::span<const std::byte> bytes, std::string file)
        : rest_(reinterpret_cast<const char*>(bytes.data()), bytes.size()), file_(std::move(file)) {
    }

    /// Goes to the next line; false at the end.
    bool next() {
        if (rest_.empty()) return false;
        const std::size_t end = rest_.find('\n');
        line_ = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        ++number_;
        return true;
    }
    /// The line's next word; empty: none is left.
    std::string_view word() {
        const std::size_t start = std::min(line_.find_first_not_of(" \t\r"), line_.size());
        line_.remove_prefix(start);
        const std::string_view found = line_.substr(0, line_.find_first_of(" \t\r"));
        line_.remove_prefix(found.size());
        return found;
    }
    /// What is left of the line, without blanks around it.
    [[nodiscard]] std::string_view remainder() const {
        const std::size_t start = line_.find_first_not_of(" \t\r");
        if (start == std::string_view::npos) return {};
        return line_.substr(start, line_.find_last_not_of(" \t\r") + 1 - start);
    }
    /// The next word as a number; what overflows is NaN. Throws DeviceError where it is none.
    float number(std::string_view what) {
        const auto value = optionalNumber(what);
        if (!value) fail(what, "", "a number");
        return *value;
    }
    /// The same, or nothing where the line is over.
    std::optional<float> optionalNumber(std::string_view what) {
        std::string_view text = word();
        if (text.empty()) return std::nullopt;
        if (text.front() == '+') text.remove_prefix(1);
        float value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc::result_out_of_range) return std::numeric_limits<float>::quiet_NaN();
        if (error != std::errc{} || end != text.data() + text.size()) fail(what, text, "a number");
        return value;
    }
    [[noreturn]] void fail(std::string_view key, std::string_view value,
                           std::string_view allowed) const {
        constexpr std::size_t kMostShown = 40;
        throw DeviceError(file_ + ":" + std::to_string(number_) + ": " + std::string(key) + " = '" +
                          std::string(value.substr(0, kMostShown)) + "' (allowed " +
                          std::string(allowed) + ")");
    }
    [[nodiscard]] std::string_view unread() const { return rest_; }

  private:
    std::string_view rest_, line_;
    std::string file_;
    std::size_t number_ = 0;
};

} // namespace autostereo::devices::mesh

#pragma once

#include "config/toml_reader.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Pieces of error messages. Reentrant.
namespace autostereo::config {

/// Ten significant digits, no trailing zeros.
[[nodiscard]] std::string plain(double value);

/// "(allowed 1 to 10)"
[[nodiscard]] std::string allowed(Range range);
/// "(allowed a, b, c)"
[[nodiscard]] std::string allowed(const std::vector<std::string_view>& words);

/// The word that `typed` was probably meant to be (at most two letters off and at least half of
/// them right), else empty.
[[nodiscard]] std::string_view nearestWord(std::string_view typed,
                                           const std::vector<std::string_view>& words);

/// Control characters of foreign text as '?', and not longer than a terminal's few lines.
[[nodiscard]] std::string oneLine(std::string message);

} // namespace autostereo::config

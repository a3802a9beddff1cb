#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace autostereo::config {

/// One span of opening, local time.
struct OpeningSpan {
    std::uint8_t days = 0; ///< on which it begins: bit 0 is Monday
    int from = 0;          ///< minutes of the day, 0 to 1439
    int to = 0;            ///< 1 to 1440; not later than `from`: on the next day

    [[nodiscard]] bool operator==(const OpeningSpan&) const = default;
};

/// "mon-fri 09:00-18:00", "sat,sun 10:00-16:30", "fri 20:00-02:00" or "daily 08:00-24:00"; nothing
/// where it is none of these.
[[nodiscard]] std::optional<OpeningSpan> openingSpan(const std::string& text);

/// Whether any of them holds; without any it is always open. `weekday`: 0 is Monday. Reentrant.
[[nodiscard]] bool isOpen(const std::vector<OpeningSpan>& spans, int weekday, int minute);

} // namespace autostereo::config

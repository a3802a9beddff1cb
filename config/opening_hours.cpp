#include "config/opening_hours.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>
#include <string_view>

namespace autostereo::config {

namespace {

constexpr int kWeek = 7, kDay = 24 * 60;

/// 0 is Monday.
std::optional<int> dayOf(std::string_view word) {
    constexpr std::array<std::string_view, kWeek> kDays{"mon", "tue", "wed", "thu",
                                                        "fri", "sat", "sun"};
    const auto found = std::ranges::find(kDays, word);
    if (found == kDays.end()) return std::nullopt;
    return static_cast<int>(found - kDays.begin());
}

/// Days between commas, each one or a range that may pass Sunday; 0: not understood.
std::uint8_t daysOf(const std::string& text) {
    if (text == "daily") return (1U << kWeek) - 1;
    unsigned days = 0;
    std::istringstream parts(text + ',');
    for (std::string part; std::getline(parts, part, ',');) {
        const auto dash = part.find('-');
        const auto first = dayOf(part.substr(0, dash));
        const auto last = dash == std::string::npos ? first : dayOf(part.substr(dash + 1));
        if (!first || !last) return 0;
        for (int day = *first;; day = (day + 1) % kWeek) {
            days |= 1U << static_cast<unsigned>(day);
            if (day == *last) break;
        }
    }
    return static_cast<std::uint8_t>(days);
}

} // namespace

std::optional<OpeningSpan> openingSpan(const std::string& text) {
    std::array<char, 32> days{};
    int fromHour = 0, fromMinute = 0, toHour = 0, toMinute = 0;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%31s %2d:%2d-%2d:%2d%c", days.data(), &fromHour, &fromMinute,
                    &toHour, &toMinute, &rest) != 5)
        return std::nullopt;
    const auto isMinute = [](int minute) { return minute >= 0 && minute < 60; };
    const OpeningSpan span{daysOf(days.data()), 60 * fromHour + fromMinute, 60 * toHour + toMinute};
    if (span.days == 0 || !isMinute(fromMinute) || !isMinute(toMinute) || fromHour < 0 ||
        span.from >= kDay || toHour < 0 || span.to > kDay || span.from == span.to)
        return std::nullopt;
    return span;
}

bool isOpen(const std::vector<OpeningSpan>& spans, int weekday, int minute) {
    const auto beginsOn = [](const OpeningSpan& span, int day) {
        return ((span.days >> static_cast<unsigned>(day % kWeek)) & 1U) != 0;
    };
    return spans.empty() || std::ranges::any_of(spans, [&](const OpeningSpan& span) {
               const bool overnight = span.to <= span.from;
               const int end = overnight ? kDay : span.to;
               return (beginsOn(span, weekday) && minute >= span.from && minute < end) ||
                      (overnight && beginsOn(span, weekday + kWeek - 1) && minute < span.to);
           });
}

} // namespace autostereo::config

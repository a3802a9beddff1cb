#include "config/phrases.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <sstream>

namespace autostereo::config {

namespace {

/// Levenshtein's: letters to insert, remove or replace.
std::size_t editDistance(std::string_view from, std::string_view to) {
    std::vector<std::size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < from.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < to.size(); ++j) {
            const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

} // namespace

std::string plain(double value) {
    std::ostringstream out;
    out.precision(10);
    out << value;
    return out.str();
}

std::string allowed(Range range) {
    return "(allowed " + plain(range.low) + " to " + plain(range.high) + ')';
}

std::string allowed(const std::vector<std::string_view>& words) {
    std::string list;
    for (const std::string_view word : words)
        list.append(list.empty() ? "" : ", ").append(word);
    return "(allowed " + list + ')';
}

std::string_view nearestWord(std::string_view typed, const std::vector<std::string_view>& words) {
    constexpr std::size_t kLongest = 64; // no key is longer; bounds the work on foreign text
    if (typed.size() > kLongest) return {};
    std::string_view nearest;
    std::size_t least = std::min<std::size_t>(2, typed.size() / 2) + 1;
    for (const std::string_view word : words) {
        const std::size_t distance = editDistance(typed, word);
        if (distance < least) {
            least = distance;
            nearest = word;
        }
    }
    return nearest;
}

std::string oneLine(std::string message) {
    constexpr std::size_t kLongest = 500;
    if (message.size() > kLongest) message.replace(kLongest, std::string::npos, "...");
    std::replace_if(
        message.begin(), message.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
    return message;
}

} // namespace autostereo::config

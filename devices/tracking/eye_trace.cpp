#include "devices/tracking/eye_trace.hpp"

#include "devices/input.hpp"
#include "devices/replay/image_files.hpp"
#include "devices/tracking/eye_source.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace autostereo::devices {

namespace {

constexpr std::size_t kNumbers = 7;
constexpr std::size_t kMostBytes = std::size_t{1} << 30U;
constexpr double kLongestS = 1e6;

/// Cuts the text up to `end` off its front, the end too.
std::string_view cut(std::string_view& text, char end) {
    const std::size_t at = text.find(end);
    const std::string_view piece = text.substr(0, at);
    text.remove_prefix(at == std::string_view::npos ? text.size() : at + 1);
    return piece;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r";
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// Empty: the line is good.
std::string parseLine(std::string_view line, std::array<double, kNumbers>& numbers) {
    std::size_t count = 0;
    while (!line.empty() && count < kNumbers) {
        const std::string_view field = trimmed(cut(line, ','));
        const char* end = field.data() + field.size();
        const auto [rest, error] = std::from_chars(field.data(), end, numbers[count]);
        if (error != std::errc{} || rest != end || !std::isfinite(numbers[count]))
            return "number " + std::to_string(count + 1) + " is none";
        ++count;
    }
    if (count < kNumbers || !line.empty())
        return "wants seconds and six coordinates, separated by commas";
    return {};
}

} // namespace

std::vector<TracedEyes> parseEyeTrace(std::string_view text, const std::string& name) {
    std::vector<TracedEyes> trace;
    for (std::size_t number = 1; !text.empty(); ++number) {
        std::string_view line = cut(text, '\n');
        line = trimmed(cut(line, '#'));
        if (line.empty()) continue;
        std::array<double, kNumbers> n{};
        std::string wrong = parseLine(line, n);
        const TracedEyes eyes{Duration(std::llround(1e9 * std::clamp(n[0], -1.0, kLongestS))),
                              {{n[1], n[2], n[3]}, {n[4], n[5], n[6]}}};
        if (wrong.empty() && !(n[0] >= 0 && n[0] <= kLongestS))
            wrong = "seconds out of range (allowed 0 to 1000000)";
        if (wrong.empty() && !trace.empty() && eyes.at <= trace.back().at)
            wrong = "is not later than the sample before it";
        if (wrong.empty() && !isPlausible(eyes.eyes))
            wrong = "no viewer's eyes (allowed 0.1 to 10 m from the panel, 10 m to each side)";
        if (!wrong.empty())
            throw DeviceError(std::string(name).append(":").append(std::to_string(number)) + ": " +
                              wrong);
        trace.push_back(eyes);
    }
    if (trace.empty()) throw DeviceError(name + ": no sample in it");
    return trace;
}

std::vector<TracedEyes> readEyeTrace(const std::filesystem::path& file) {
    const auto bytes = readFile(file, kMostBytes);
    return parseEyeTrace({reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                         file.string());
}

} // namespace autostereo::devices

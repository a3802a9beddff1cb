#include "devices/quilt_name.hpp"

#include <charconv>

namespace autostereo::devices {

std::optional<QuiltName> quiltName(const std::string& file) {
    const auto at = file.rfind("_qs");
    if (at == std::string::npos) return std::nullopt;
    const char* next = file.data() + at + 3;
    const char* end = file.data() + file.size();
    QuiltName name;
    const auto number = [&](auto& value) {
        const auto [stopped, error] = std::from_chars(next, end, value);
        next = stopped;
        return error == std::errc();
    };
    const auto letter = [&](char wanted) { return next != end && *next++ == wanted; };
    if (!number(name.columns) || !letter('x') || !number(name.rows)) return std::nullopt;
    if (name.columns < 1 || name.columns > 100 || name.rows < 1 || name.rows > 100)
        return std::nullopt;
    double aspect = 0;
    if (next != end && *next == 'a' && letter('a') && number(aspect) && aspect > 0)
        name.aspect = aspect;
    return name;
}

} // namespace autostereo::devices

#include "devices/display/recognise.hpp"

#include <algorithm>

namespace autostereo::devices {

namespace {

/// Longer patterns are more exact; of equal letters the one without a '*' is.
std::size_t exactness(const RecognitionRule& rule) {
    const bool open = rule.edidName.ends_with('*');
    return 2 * (rule.edidName.size() - (open ? 1 : 0)) + (open ? 0 : 1);
}

bool fits(const RecognitionRule& rule, const Connector& monitor) {
    return monitor.edid && edidNameFits(rule.edidName, monitor.edid->monitorName) &&
           ((rule.width == 0 && rule.height == 0) || monitor.offers(rule.width, rule.height));
}

/// The profiles of the most exact rules that fit.
void addProfiles(const Connector& monitor, std::span<const RecognitionRule> rules,
                 std::vector<Recognised>& found) {
    std::size_t best = 0;
    for (const RecognitionRule& rule : rules)
        if (fits(rule, monitor)) best = std::max(best, exactness(rule));
    for (const RecognitionRule& rule : rules) {
        const Recognised one{rule.profile, monitor.card, monitor.name};
        if (fits(rule, monitor) && exactness(rule) == best &&
            std::ranges::find(found, one) == found.end())
            found.push_back(one);
    }
}

std::string namesOf(std::span<const Connector> monitors) {
    std::string names;
    for (const Connector& monitor : monitors) {
        names += (names.empty() ? "" : ", ") + monitor.name + " ";
        names += monitor.edid ? "'" + monitor.edid->monitorName + "'" : "without an EDID";
    }
    return names;
}

} // namespace

bool edidNameFits(std::string_view pattern, std::string_view name) {
    if (pattern.empty() || pattern == "*") return false; // would take any monitor
    if (!pattern.ends_with('*')) return name == pattern;
    return name.starts_with(pattern.substr(0, pattern.size() - 1));
}

Recognition recognise(std::span<const Connector> monitors, std::span<const RecognitionRule> rules) {
    std::vector<Recognised> found;
    for (const Connector& monitor : monitors)
        addProfiles(monitor, rules, found);
    if (found.size() == 1) return found.front();
    if (monitors.empty()) return NotRecognised{"no monitor is connected"};
    if (found.empty())
        return NotRecognised{"no display profile fits a connected monitor (" + namesOf(monitors) +
                             ")"};
    Ambiguous ambiguous{found, "more than one display is possible:"};
    for (const Recognised& one : found)
        ambiguous.reason += " " + one.profile + " on " + one.card + " " + one.connector + ",";
    ambiguous.reason.back() = ';';
    ambiguous.reason += " choose one with --display, and unplug or turn off the others";
    return ambiguous;
}

} // namespace autostereo::devices

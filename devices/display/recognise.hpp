#pragma once

#include "devices/display/connectors.hpp"

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace autostereo::devices {

/// A display profile as far as its monitor can be told from others.
struct RecognitionRule {
    std::string profile;  ///< "looking-glass-portrait"
    std::string edidName; ///< the EDID's monitor name; a last '*' stands for any rest. Empty: never
    int width = 0;        ///< native size, pixels; 0 x 0: any
    int height = 0;
};

struct Recognised {
    std::string profile;
    std::string card;      ///< "card0"
    std::string connector; ///< "HDMI-A-1"
    [[nodiscard]] bool operator==(const Recognised&) const = default;
};
struct NotRecognised {
    std::string reason; ///< one sentence
};
/// More than one answer; nothing is guessed.
struct Ambiguous {
    std::vector<Recognised> candidates;
    std::string reason; ///< one sentence that names them and says what to do
};

using Recognition = std::variant<Recognised, NotRecognised, Ambiguous>;

/// A rule fits a monitor when the EDID's name does and the monitor has a mode of its size. Of the
/// rules that fit a monitor, those of most letters count: an exact name, then the longest pattern.
/// Several monitors, or rules of equal length with different profiles, are ambiguous. Pure.
[[nodiscard]] Recognition recognise(std::span<const Connector> monitors,
                                    std::span<const RecognitionRule> rules);

/// `pattern` as in RecognitionRule.
[[nodiscard]] bool edidNameFits(std::string_view pattern, std::string_view name);

} // namespace autostereo::devices

#pragma once

#include <array>
#include <cstdint>

namespace autostereo::calib {

/// Pictures of known content, one per view, that show what a display does with it.
enum class TestPattern {
    Numbers, ///< each view's number, counted from the left, in its own colour
    Colors,  ///< each view one colour, hue rising from the left
    Lines,   ///< an upright and a level line in the middle view, fainter in its neighbours
    Halves, ///< left half of the fan black, right half white: what an eye gets of the other's light
    Ramps   ///< even views a grey ramp to the right, odd ones to the left: light between neighbours
};

/// Gamma-encoded colour at (u, v) of a view's picture, u rightwards and v upwards in [0, 1].
/// `aspect`: the picture's width / height.
[[nodiscard]] std::array<std::uint8_t, 3> patternColor(TestPattern pattern, int view, int views,
                                                       double aspect, double u, double v);

} // namespace autostereo::calib

#pragma once

#include <glm/vec3.hpp>

#include <span>

namespace autostereo::calibrate {

/// Where a moving board's middle was at one moment, by one camera.
struct TimedPlace {
    double timeS = 0;    ///< the picture's stamp
    glm::dvec3 place{0}; ///< metres, in the depth camera's frame
};

struct TimeOffset {
    double colorLateS = 0;   ///< the colour camera's stamps minus the depth camera's, of one moment
    double late95S = 0;      ///< half the 95 % interval
    glm::dvec3 shift{0};     ///< of the colour camera's places: what the rig is off by, metres
    std::size_t moments = 0; ///< depth places that could be compared
    glm::dvec3 rmsM{0};      ///< residuals along each axis
};

/// The offset between two cameras' clocks from a board that both follow while it moves: colour
/// places are joined by a cubic through four of them, depth places compared with that, tried over
/// 100 ms to either side, then least squares, axes weighed by their own residuals. Both
/// tracks in order of time. Throws Refusal where the board moved too little, or was seen too
/// seldom, to tell the offset to 5 ms.
[[nodiscard]] TimeOffset timeOffset(std::span<const TimedPlace> depth,
                                    std::span<const TimedPlace> color);

} // namespace autostereo::calibrate

#pragma once

#include "calib/eye_pair.hpp"
#include "devices/tracking/params.hpp"

namespace autostereo::devices {

/// What a head tracker says, in its own axes and signs.
struct HeadPose {
    glm::dvec3 positionM{0};
    double yawRad = 0;
    double pitchRad = 0;
    double rollRad = 0;
};

/// `v` after right-handed turns about x, then y, then z, radians.
[[nodiscard]] glm::dvec3 turned(glm::dvec3 v, const glm::dvec3& angles);

/// The eyes of a head that looks at the panel (along -z), `spacingM` apart. Turned to its right
/// (yaw > 0) the right eye is farther from the panel than the left one, leant to its right (roll >
/// 0) lower; pitch turns about the line through both and moves neither. `nominal`: the tracker's
/// origin where the pose gives none.
[[nodiscard]] calib::EyePair eyesOf(const HeadPose& head, const TrackerPose& tracker,
                                    const glm::dvec3& nominal, double spacingM);

} // namespace autostereo::devices

#pragma once

#include "calib/display_profile.hpp"
#include "gpu/gl/api.hpp"

namespace autostereo::daemon {

/// What a picture that stands for the cameras' is drawn for, and where to.
struct StandingTarget {
    const calib::DisplayProfile& display;
    int width, height; ///< of the panel, pixels
    GLuint framebuffer;
};

} // namespace autostereo::daemon

#pragma once

#include "calib/picture.hpp"
#include "daemon/session/standing_target.hpp"

#include <string>

namespace autostereo::daemon {

/// Words before a picture (none: a plain one), the same for all eyes. Throws GlError.
void drawMessage(const calib::Picture& background, const std::string& text,
                 const StandingTarget& target);

} // namespace autostereo::daemon

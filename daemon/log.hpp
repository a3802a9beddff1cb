#pragma once

#include <string>

namespace autostereo::daemon {

/// Log to stderr without time stamps: "[warning] text"; to the journal itself, with fields, where
/// it reads our stderr.
void setUpLog(const std::string& level);

} // namespace autostereo::daemon

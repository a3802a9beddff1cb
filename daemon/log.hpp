#pragma once

#include <string>

namespace autostereo::daemon {

/// Log to stderr without time stamps (the journal adds them): "[warning] text".
void setUpLog(const std::string& level);

} // namespace autostereo::daemon

#include "daemon/commands.hpp"

namespace autostereo::daemon {

int look(const LookOptions& /*options*/) { throw UsageError("look: not in this version"); }

} // namespace autostereo::daemon

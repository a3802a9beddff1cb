#include "daemon/commands.hpp"

namespace autostereo::daemon {

int importCalibration(const ImportOptions& /*options*/) {
    throw UsageError("import: not in this version");
}

} // namespace autostereo::daemon

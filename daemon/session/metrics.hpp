#pragma once

#include "daemon/session/status.hpp"

#include <cstdint>
#include <string>

namespace autostereo::daemon {

/// What a running program counts and measures, as Prometheus reads it (text format 0.0.4): every
/// family with # HELP and # TYPE; seconds and bytes; what is not known is left out.
/// `residentBytes`: the program's memory, 0: not known.
[[nodiscard]] std::string metricsText(const Status& status, const Report& report,
                                      std::uint64_t residentBytes);

/// Of this process, bytes; 0 where the kernel does not say.
[[nodiscard]] std::uint64_t residentMemory();

} // namespace autostereo::daemon

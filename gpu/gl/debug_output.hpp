#pragma once

#include <cstdint>

namespace autostereo::gpu::gl {

/// Routes KHR_debug messages of the current context to the log: errors and undefined behaviour
/// as errors, performance hints at debug level.
void logDebugOutput();

/// Errors and undefined-behaviour messages so far in this process; tests demand zero.
[[nodiscard]] std::uint64_t debugErrorCount();

} // namespace autostereo::gpu::gl

#pragma once

#include <stdexcept>

namespace autostereo::gpu {

/// Thrown while building GL objects, contexts and windows.
class GlError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// No display server, or no monitor in the mode that was asked for.
class DisplayNotFound : public GlError {
  public:
    using GlError::GlError;
};

/// What was there is gone: the GPU was reset, the monitor unplugged or set to another mode. Nothing
/// that lives in the context can be saved, and drivers start best in a new process.
class PanelLost : public GlError {
  public:
    using GlError::GlError;
};

} // namespace autostereo::gpu

#pragma once

#include <stdexcept>

namespace autostereo::gpu {

/// Thrown while building GL objects, contexts and windows; never per frame.
class GlError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// No display server, or no monitor in the mode that was asked for.
class DisplayNotFound : public GlError {
  public:
    using GlError::GlError;
};

} // namespace autostereo::gpu

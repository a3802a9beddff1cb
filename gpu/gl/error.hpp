#pragma once

#include <stdexcept>

namespace autostereo::gpu {

/// Thrown while building GL objects, contexts and windows; never per frame.
class GlError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

} // namespace autostereo::gpu

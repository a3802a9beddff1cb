#pragma once

#include <stdexcept>

namespace autostereo::calibrate {

/// The pictures cannot support what was asked of them; one line that says why and what to do.
class Refusal : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

} // namespace autostereo::calibrate

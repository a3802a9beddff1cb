#pragma once

#include "config/load.hpp"

namespace autostereo::config {

/// Key by key, so that a failure names the one that differs; `[scene]` has a test of its own.
void expectSame(const Config& a, const Config& b);

} // namespace autostereo::config

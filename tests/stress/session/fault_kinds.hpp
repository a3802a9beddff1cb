#pragma once

#include "tests/stress/session/rehearsal.hpp"

#include <functional>
#include <random>
#include <string>
#include <vector>

namespace autostereo::test {

using Random = std::mt19937;

/// One way in which things go wrong.
struct FaultKind {
    std::string name;
    /// Makes it so for a while, and good again.
    std::function<void(Rehearsal&, Random&)> happen;
    std::string counter; ///< which must have risen when all is right again
    std::function<std::uint64_t(Rehearsal&)> count;
};

/// Of sensors, of the operator, of the machine.
[[nodiscard]] std::vector<FaultKind> faultKinds();

} // namespace autostereo::test

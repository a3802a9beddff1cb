#pragma once

#include <cstdint>
#include <cstdlib>

namespace autostereo::test {

/// The share of a campaign that runs in CI, or all of it with AUTOSTEREO_FULL=1.
inline std::uint64_t campaign(std::uint64_t share, std::uint64_t full) {
    const char* wanted = std::getenv("AUTOSTEREO_FULL");
    return wanted != nullptr && *wanted == '1' ? full : share;
}

} // namespace autostereo::test

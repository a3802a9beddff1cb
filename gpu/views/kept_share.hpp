#pragma once

namespace autostereo::gpu {

/// Shares of the panel, 0..1, mean of the frames counted so far.
struct KeptShare {
    double search = 0;  ///< not searched anew
    double picture = 0; ///< not even drawn anew
};

} // namespace autostereo::gpu

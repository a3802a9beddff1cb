#include "calib/view_map.hpp"

namespace autostereo::calib {

double viewPosition(const DisplayProfile& display, int view) {
    if (display.views == 1) return 0;
    if (display.fan == Fan::Edges) return 2.0 * view / (display.views - 1) - 1;
    return (2.0 * view + 1) / display.views - 1;
}

} // namespace autostereo::calib

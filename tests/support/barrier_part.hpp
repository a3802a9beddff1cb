#pragma once

#include "config/load.hpp"

namespace autostereo::test {

/// The middle of a real panel behind its real barrier, small enough to draw often.
inline calib::DisplayProfile barrierPart(int width, int height) {
    calib::DisplayProfile display = config::loadDisplay("personal-varrier-30-b");
    display.widthM *= static_cast<double>(width) / display.width;
    display.width = width;
    display.height = height;
    display.quilt = {2, 1, width, height};
    return display;
}

} // namespace autostereo::test

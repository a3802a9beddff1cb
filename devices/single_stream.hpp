#pragma once

#include "devices/input.hpp"

namespace autostereo::devices {

/// Makes an input with one stream a complete one, so that nothing downstream needs to know.
/// Colour alone: a flat depth frame 1 m away for each colour frame, so that the picture stands in
/// the panel's plane. Depth alone: a shaded grey picture for each depth frame, from a colour camera
/// that is the depth camera. Both streams are passed through unchanged. The two sources may be read
/// on two threads or in turns on one. Throws DeviceError where the one camera is not known.
[[nodiscard]] Input completeStreams(Input input);

} // namespace autostereo::devices

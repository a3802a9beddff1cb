#pragma once

#include "devices/tracking/eye_source.hpp"
#include "devices/tracking/params.hpp"

#include <memory>

namespace autostereo::devices {

/// Opens params.source: `camera:URI` (CameraSource; the URI of any input with colour), `camera:`
/// (OwnCameraSource: the daemon's own, whose pictures have to be handed in; `hurried`: they come
/// from a recording as fast as it can be read), `file:TRACE`
/// (eye_trace.hpp; its zero is `start`) or `opentrack:[ADDRESS:]PORT` (loopback without an
/// address). `nominal`: the middle of the display's nominal eyes, which a tracker without an origin
/// counts from. `clock` must outlive it. Throws DeviceError.
[[nodiscard]] std::unique_ptr<EyeSource> openEyes(const ViewerParams& params,
                                                  const glm::dvec3& nominal, TimePoint start,
                                                  bool hurried, Clock& clock);

} // namespace autostereo::devices

#pragma once

#include "daemon/control/control_server.hpp"
#include "gpu/readback.hpp"

#include <string>

namespace autostereo::daemon {

/// The picture that a reply carries, as `snapshot` is answered. Throws std::runtime_error where
/// there is none.
[[nodiscard]] gpu::RgbImage pictureIn(const ControlReply& reply);

/// No side longer than `longest` pixels: a smaller one's pixels are the means of those that they
/// cover, rounded. Reentrant.
[[nodiscard]] gpu::RgbImage shrunk(gpu::RgbImage image, int longest);

/// A PNG file's bytes. Reentrant.
[[nodiscard]] std::string pngOf(const gpu::RgbImage& image);

} // namespace autostereo::daemon

#pragma once

#include "devices/frame.hpp"

#include <cstddef>
#include <span>

namespace autostereo::devices::v4l2 {

/// Bytes of a driver's buffer whose first plane's rows are `stride` bytes apart, at least.
/// 0: sizes that cannot be (a stride shorter than a row, or beyond any memory).
[[nodiscard]] std::size_t bufferBytes(PixelFormat format, int width, int height,
                                      std::size_t stride);

/// Copies a driver's buffer into a frame of that format and size, row by row. False: the buffer
/// is too short; the frame's contents are then undefined.
[[nodiscard]] bool unpack(std::span<const std::byte> buffer, std::size_t stride, Frame& frame);

} // namespace autostereo::devices::v4l2

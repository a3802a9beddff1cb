#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace autostereo::devices {

/// The same JPEG with its columns reversed, without loss. Its width has to be a multiple of 16.
/// Reentrant; throws std::runtime_error.
[[nodiscard]] std::vector<std::byte> mirroredJpeg(std::span<const std::byte> jpeg);

} // namespace autostereo::devices

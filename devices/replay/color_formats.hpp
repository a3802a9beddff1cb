#pragma once

#include <cstddef>
#include <span>

namespace autostereo::devices {

/// Uncompressed colour as cameras deliver it -> Rgba8, tightly packed, top row first. Sizes must
/// be even where the format halves them. YUV is BT.601 with 16..235 for luma, which is how the
/// Azure Kinect's own software reads these formats. Reentrant; the caller has checked the sizes.
void nv12ToRgba(std::span<const std::byte> from, std::size_t width, std::size_t height,
                std::span<std::byte> to);
void yuy2ToRgba(std::span<const std::byte> from, std::span<std::byte> to);
void bgraToRgba(std::span<const std::byte> from, std::span<std::byte> to);

} // namespace autostereo::devices

#pragma once

#include "calib/display_laws.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

// Header of Philips WOWvx 2D-plus-depth frames (layout as in OpenSceneGraph's WoWVxDisplay): 10
// bytes 0xF1, content type, factor, offset, 0, 0, CRC-32 big-endian. Pure functions; reentrant.

namespace autostereo::calib {

/// Polynomial 0x04C11DB7, initial 0, most significant bit first, no reflection, no final xor.
[[nodiscard]] std::uint32_t depthFrameCrc(std::span<const std::uint8_t> bytes);

[[nodiscard]] std::array<std::uint8_t, 10> depthFrameHeader(const DepthFrame& frame);

/// Blue levels of the top row from x = 0: bit b (7 first) of byte n at x = 2 (7 - b) + 16 n, 255
/// for a one; everything between and up to x = 255 is 0.
[[nodiscard]] std::vector<std::uint8_t> depthFrameHeaderRow(const DepthFrame& frame);

} // namespace autostereo::calib

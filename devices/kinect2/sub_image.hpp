#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace autostereo::devices::kinect2 {

inline constexpr int kWidth = 512;
inline constexpr int kHeight = 424;
inline constexpr std::size_t kPixels = std::size_t{kWidth} * kHeight;

/// A frame is three phase-shifted images (0, 120, 240 degrees) at each of three modulation
/// frequencies (80, 16, 120 MHz in this order) and a tenth of unknown use.
inline constexpr std::size_t kFrequencies = 3;
inline constexpr std::size_t kShifts = 3;
inline constexpr std::size_t kUsedSubImages = kFrequencies * kShifts;
inline constexpr std::size_t kSubImages = 10;

inline constexpr std::size_t kRowBytes = 704;
inline constexpr std::size_t kSubImageBytes = kRowBytes * kHeight; // 11 bits a pixel

/// What an 11-bit code that stands for an overexposed sample becomes.
inline constexpr std::int16_t kSaturated = 32767;

/// The sample behind each code: sign and magnitude, the magnitude's steps growing from 1 to 64
/// counts; -16320 to 16320, or kSaturated.
[[nodiscard]] const std::array<std::int16_t, 2048>& companding();

/// Samples of one row of the picture (0: top) in the order of its columns. Columns 0 and 511 are
/// not measured. The sensor is read from the middle outwards, so the lower half is stored upside
/// down. Reentrant.
void unpackRow(std::span<const std::byte, kSubImageBytes> subImage, int row,
               std::span<std::int16_t, kWidth> samples);

} // namespace autostereo::devices::kinect2

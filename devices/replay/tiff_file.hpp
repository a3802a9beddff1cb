#pragma once

#include <filesystem>
#include <span>

namespace autostereo::devices {

/// One channel of 32-bit floats, `width` x `height` of them, top row first, as an uncompressed
/// baseline TIFF (revision 6.0, section 3) with SampleFormat 3. Throws std::runtime_error.
void writeTiff(const std::filesystem::path& path, int width, int height,
               std::span<const float> samples);

} // namespace autostereo::devices

#pragma once

#include "devices/frame.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace autostereo::devices {

/// A picture's brightness: of colours their luma (BT.601, as JPEG has it), 0 to 255; 16-bit grey as
/// it is. Top row first.
struct GreyPixels {
    int width = 0;
    int height = 0;
    std::vector<std::uint16_t> values;
    bool is16Bit = false;
};

/// PNG or JPEG; throws DeviceError or std::runtime_error naming the file.
[[nodiscard]] GreyPixels readGrey(const std::filesystem::path& file);

/// A colour frame; empty for a depth frame. Of Y'CbCr its Y as it is, in whatever range.
[[nodiscard]] GreyPixels greyOf(const Frame& frame);

} // namespace autostereo::devices

#pragma once

#include "calib/eye_pair.hpp"
#include "devices/clock.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace autostereo::devices {

/// A recorded viewer: CSV, one sample a line, in display space:
///
///     # seconds, left eye x, y, z, right eye x, y, z (metres)
///     0.000, -0.0315, 0, 0.65, 0.0315, 0, 0.65
///     0.016, -0.0305, 0, 0.65, 0.0325, 0, 0.65
///
/// Seconds from 0 on, rising; empty lines and what follows # count for nothing. Where the tracker
/// lost its viewer there is a gap.
struct TracedEyes {
    Duration at;
    calib::EyePair eyes;
};

/// `name` is for messages: "NAME:LINE: what is wrong (allowed ...)". At most 10 million samples.
/// Throws DeviceError.
[[nodiscard]] std::vector<TracedEyes> parseEyeTrace(std::string_view text, const std::string& name);
/// Throws DeviceError.
[[nodiscard]] std::vector<TracedEyes> readEyeTrace(const std::filesystem::path& file);

} // namespace autostereo::devices

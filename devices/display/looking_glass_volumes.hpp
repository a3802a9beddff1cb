#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace autostereo::devices {

/// A line of /proc/mounts, its escapes (\040 for a space) resolved.
struct Mount {
    std::string device; ///< "/dev/sda1"
    std::string point;
    std::string type; ///< "vfat"
    [[nodiscard]] bool operator==(const Mount&) const = default;
};

/// Lines that are none are left out. Takes any text; pure.
[[nodiscard]] std::vector<Mount> parseMounts(std::string_view text);

/// Where a Looking Glass keeps its calibration: the display's own small USB volume (Portrait and
/// later), or what the vendor's Bridge has copied from it.
struct LookingGlassVolume {
    std::string label;  ///< the volume's, "LKG-P00000", or the serial in Bridge's cache
    std::string device; ///< "/dev/sda1"; empty in Bridge's cache
    std::optional<std::filesystem::path> calibration; ///< visual.json; nothing: not mounted
};

/// Volumes labelled LKG-..., mounted volumes with LKG_calibration/visual.json, then Bridge's copies
/// in `home` (empty: none). All paths lie below `root` ("/" but in tests) and are returned with it.
/// Optical drives, and whatever is not on a block device, are not touched: a dead network mount
/// would block for ever. Never throws but for memory. Reentrant.
[[nodiscard]] std::vector<LookingGlassVolume>
findLookingGlassVolumes(const std::filesystem::path& root, const std::filesystem::path& home);

/// A calibration file's text; nothing where it cannot be read or has more than 1 MiB.
[[nodiscard]] std::optional<std::string> readCalibrationText(const std::filesystem::path& file);

} // namespace autostereo::devices

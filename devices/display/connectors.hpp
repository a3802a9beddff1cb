#pragma once

#include "devices/display/edid.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace autostereo::devices {

/// A video output of a graphics card with a monitor on it.
struct Connector {
    struct Mode {
        int width = 0; ///< pixels
        int height = 0;
        [[nodiscard]] bool operator==(const Mode&) const = default;
    };

    std::string card;         ///< "card0"
    std::string name;         ///< the kernel's, "HDMI-A-1"; two cards may have the same
    bool enabled = false;     ///< shows a picture now
    std::optional<Edid> edid; ///< nothing: see `edidProblem`
    std::string edidProblem;  ///< why there is no EDID, one sentence
    std::vector<Mode> modes;  ///< preferred first, progressive ones, each size once

    /// The size is the preferred timing's or among the modes (of 8K panels only there).
    [[nodiscard]] bool offers(int width, int height) const;
};

/// Connected monitors by /sys/class/drm below `root` ("/" but in tests), sorted by card and name.
/// What cannot be read is left out. Reads files of at most 64 KiB; never throws but for memory.
[[nodiscard]] std::vector<Connector> connectedMonitors(const std::filesystem::path& root);

} // namespace autostereo::devices

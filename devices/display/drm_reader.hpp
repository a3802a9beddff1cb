#pragma once

#include "devices/display/drm_properties.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace autostereo::devices {

struct DrmReading {
    std::vector<DrmPipe> pipes;     ///< of connectors with a monitor on them
    std::vector<std::string> notes; ///< cards that could not be read, and why; no errors
};

/// Asks every card0, card1, ... in `folder` ("/dev/dri" but in tests) for its properties. Reads
/// only: nothing is probed, set or lit, and the right to set modes, which the kernel gives to
/// whoever comes first, is handed back at once. Never throws but for memory. Reentrant.
[[nodiscard]] DrmReading readDrm(const std::filesystem::path& folder);

} // namespace autostereo::devices

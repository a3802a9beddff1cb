#pragma once

#include "calib/display_profile.hpp"
#include "devices/display/link_state.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace autostereo::daemon {

/// Where a display and its calibration are looked for; tests put folders of their own here.
struct DisplayPlaces {
    std::filesystem::path root = "/"; ///< of sys, proc and dev
    std::filesystem::path home;       ///< below root; the vendor's own cache lies below it
    std::filesystem::path state;      ///< last good calibrations are kept below it
    bool usb = true;                  ///< first-generation displays are asked over USB

    /// From HOME and STATE_DIRECTORY (systemd), else XDG's state folder.
    [[nodiscard]] static DisplayPlaces ofSystem();
};

/// What is connected, as far as it is known.
struct FoundDisplay {
    std::optional<calib::DisplayProfile> profile; ///< none: nothing was recognised
    std::string connector;                        ///< the kernel's name; empty: not known
    std::vector<std::string> warnings;            ///< one sentence each
};

/// The monitor's profile by its EDID; a Looking Glass' with its unit's own calibration, from its
/// volume, over USB, or as it was kept when it last was good.
[[nodiscard]] FoundDisplay findDisplay(const DisplayPlaces& places);

/// What spoils sub-pixels on the way to the only monitor that offers the display's mode (or the
/// one on `connector`), the worst first; empty where no such monitor is known.
[[nodiscard]] std::vector<devices::LinkProblem> linkProblemsOf(const DisplayPlaces& places,
                                                               const calib::DisplayProfile& display,
                                                               const std::string& connector);

} // namespace autostereo::daemon

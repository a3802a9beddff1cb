#include "daemon/find_display.hpp"

#include "config/load.hpp"
#include "config/looking_glass_json.hpp"
#include "devices/clock.hpp"
#include "devices/display/calibration_cache.hpp"
#include "devices/display/connectors.hpp"
#include "devices/display/drm_reader.hpp"
#include "devices/display/looking_glass_volumes.hpp"
#include "devices/display/recognise.hpp"
#include "devices/display/usb_hid.hpp"
#include "devices/input.hpp"

#include <algorithm>
#include <cstdlib>

namespace autostereo::daemon {

namespace {

std::filesystem::path pathOf(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr ? value : "";
}

/// A calibration as its display gave it just now.
struct Given {
    std::string serial;
    std::optional<std::string> text;
};

std::optional<Given> overUsb(std::vector<std::string>& warnings) {
    try {
        const auto transport = devices::openLookingGlassHid();
        if (!transport) return std::nullopt;
        const devices::SteadyClock clock;
        return Given{"LKG-USB", devices::readHidCalibration(*transport, clock)};
    } catch (const devices::DeviceError& error) {
        warnings.emplace_back(error.what());
        return std::nullopt;
    }
}

std::optional<Given> given(const DisplayPlaces& places, std::vector<std::string>& warnings) {
    const auto volumes = devices::findLookingGlassVolumes(places.root, places.home);
    if (volumes.size() > 1)
        warnings.push_back("several Looking Glass calibrations are there: " +
                           volumes.front().label + "'s is taken (give --display FILE)");
    if (volumes.empty()) return places.usb ? overUsb(warnings) : std::nullopt;
    const auto& volume = volumes.front();
    if (!volume.calibration) {
        warnings.push_back("volume " + volume.label + " is not mounted: mount " + volume.device +
                           " to read the display's calibration");
        return Given{volume.label, std::nullopt};
    }
    return Given{volume.label, devices::readCalibrationText(*volume.calibration)};
}

/// The unit's own calibration as a profile, where a good one is to be had.
std::optional<calib::DisplayProfile> ownCalibration(const DisplayPlaces& places,
                                                    std::vector<std::string>& warnings) {
    const auto found = given(places, warnings);
    if (!found) return std::nullopt;
    const auto chosen =
        devices::chooseCalibration(found->serial, found->text, config::calibrationProblem,
                                   devices::CalibrationCache(places.state / "calibrations"));
    warnings.insert(warnings.end(), chosen.warnings.begin(), chosen.warnings.end());
    if (chosen.text.empty()) return std::nullopt;
    auto profile = config::displayFromText(found->serial + ".json", chosen.text);
    profile.name = found->serial;
    return profile;
}

std::vector<devices::RecognitionRule> rules() {
    std::vector<devices::RecognitionRule> all;
    for (const std::string& name : config::displayNames()) {
        const auto display = config::loadDisplay(name);
        for (const std::string& edidName : display.edidNames)
            all.push_back({name, edidName, display.width, display.height});
    }
    return all;
}

} // namespace

DisplayPlaces DisplayPlaces::ofSystem() {
    DisplayPlaces places;
    places.home = pathOf("HOME");
    places.state = pathOf("STATE_DIRECTORY");
    if (places.state.empty()) {
        const auto folder = pathOf("XDG_STATE_HOME");
        places.state = (folder.empty() ? places.home / ".local/state" : folder) / "autostereo";
    }
    return places;
}

FoundDisplay findDisplay(const DisplayPlaces& places) {
    FoundDisplay found;
    const auto monitors = devices::connectedMonitors(places.root);
    const auto lookingGlass = std::ranges::find_if(monitors, [](const devices::Connector& one) {
        return one.edid && devices::isLookingGlass(*one.edid);
    });
    if (lookingGlass != monitors.end()) {
        found.connector = lookingGlass->name;
        found.profile = ownCalibration(places, found.warnings);
        if (found.profile) return found;
    }
    const auto recognition = devices::recognise(monitors, rules());
    if (const auto* one = std::get_if<devices::Recognised>(&recognition)) {
        found.connector = one->connector;
        found.profile = config::loadDisplay(one->profile);
    } else if (const auto* several = std::get_if<devices::Ambiguous>(&recognition)) {
        found.warnings.push_back(several->reason);
    }
    return found;
}

std::vector<devices::LinkProblem> linkProblemsOf(const DisplayPlaces& places,
                                                 const calib::DisplayProfile& display,
                                                 const std::string& connector) {
    const devices::Connector* monitor = nullptr;
    const auto monitors = devices::connectedMonitors(places.root);
    for (const devices::Connector& one : monitors) {
        const bool fits =
            connector.empty() ? one.offers(display.width, display.height) : one.name == connector;
        if (!fits) continue;
        if (monitor != nullptr) return {}; // which one it will be is not known
        monitor = &one;
    }
    if (monitor == nullptr) return {};
    const auto drm = devices::readDrm(places.root / "dev/dri");
    return devices::linkProblems(devices::linkOf(*monitor, drm.pipes));
}

} // namespace autostereo::daemon

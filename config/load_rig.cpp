#include "config/load.hpp"
#include "config/phrases.hpp"
#include "config/rig_file.hpp"
#include "config/text_file.hpp"
#include "devices/input.hpp"
#include "devices/replay/calibration_files.hpp"

#include <string>

namespace autostereo::config {

namespace {

/// camera.json is read where recordings are, which carry it too.
calib::SensorRig readCameraJson(const std::filesystem::path& file) {
    try {
        return devices::readCameraFile(file).rig();
    } catch (const devices::DeviceError& error) {
        throw ConfigError(oneLine(error.what()));
    }
}

} // namespace

calib::SensorRig loadRig(const std::filesystem::path& file) {
    if (file.extension() == ".json") return readCameraJson(file);
    return wholeRig(file.string(), readTextFile(file));
}

calib::SensorRig exampleRig() {
    constexpr std::string_view kName = "rigs/example.toml";
    return wholeRig(std::string(kName), embeddedText(kName));
}

} // namespace autostereo::config

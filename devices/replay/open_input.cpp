#include "devices/input.hpp"
#include "devices/replay/kinect_recording.hpp"
#include "devices/replay/picture_input.hpp"
#include "devices/sim/simulation.hpp"
#include "devices/uri.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace autostereo::devices {

namespace {

constexpr std::string_view kKnown = "sim:, tum:, seq:, rgbd:, FILE.mkv";

template<class List>
bool holds(const List& list, std::string_view what) {
    return std::find(list.begin(), list.end(), what) != list.end();
}

Input openFile(const Uri& uri, const std::optional<calib::SensorRig>& rig) {
    constexpr std::array<std::string_view, 5> kLater{".oni", ".glb", ".gltf", ".obj", ".png"};
    const std::filesystem::path path = uri.path;
    const std::string extension = path.extension().string();
    if (holds(kLater, extension))
        throw AddressError(uri.text + ": " + extension + " input is not in this version");
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        throw DeviceError("cannot open " + uri.text + ": no such file", true);
    if (extension != ".mkv")
        throw AddressError("cannot open " + uri.text + ": unknown kind of file (allowed " +
                           std::string(kKnown) + ")");
    return openKinectRecording(path, rig);
}

Input dispatch(const Uri& uri, const std::optional<calib::SensorRig>& rig) {
    constexpr std::array<std::string_view, 6> kLater{"openni2", "kinect2", "v4l2",
                                                     "quilt",   "sbs",     "idle"};
    if (uri.scheme.empty()) return openFile(uri, rig);
    if (uri.scheme == "tum") return openTum(uri, rig);
    if (uri.scheme == "seq") return openSequence(uri, rig);
    if (uri.scheme == "rgbd") return openRgbd(uri, rig);
    if (uri.scheme == "sim") {
        Input input = sim::openSimulation(uri.text);
        if (rig) input.rig = rig;
        return input;
    }
    if (holds(kLater, uri.scheme))
        throw AddressError(uri.text + ": " + uri.scheme + ": is not in this version");
    throw AddressError("cannot open " + uri.text + ": unknown scheme " + uri.scheme +
                       ": (allowed " + std::string(kKnown) +
                       "; a file name with a colon needs ./ before it)");
}

} // namespace

Input openInput(const std::string& uri, const std::optional<calib::SensorRig>& rig) try {
    return dispatch(parseUri(uri), rig);
} catch (const DeviceError&) {
    throw;
} catch (const std::exception& error) {
    throw DeviceError("cannot open " + uri + ": " + error.what());
}

} // namespace autostereo::devices

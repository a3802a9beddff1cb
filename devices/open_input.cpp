#include "devices/input.hpp"
#include "devices/kinect2/raw/raw_input.hpp"
#include "devices/kinect2/usb/open_unit.hpp"
#include "devices/mesh/open_mesh.hpp"
#include "devices/openni2/oni_file.hpp"
#include "devices/openni2/openni_input.hpp"
#include "devices/replay/kinect_recording.hpp"
#include "devices/replay/picture_input.hpp"
#include "devices/sim/simulation.hpp"
#include "devices/uri.hpp"
#include "devices/v4l2/open_camera.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace autostereo::devices {

namespace {

constexpr std::string_view kKnown =
    "sim:, tum:, seq:, rgbd:, v4l2:, openni2:, kinect2:, FILE.mkv, FILE.oni";

template<class List>
bool holds(const List& list, std::string_view what) {
    return std::find(list.begin(), list.end(), what) != list.end();
}

Input openFile(const Uri& uri, const std::optional<calib::SensorRig>& rig) {
    constexpr std::array<std::string_view, 1> kLater{".png"};
    const std::filesystem::path path = uri.path;
    const std::string extension = path.extension().string();
    if (holds(kLater, extension))
        throw AddressError(uri.text + ": " + extension + " input is not in this version");
    if (mesh::isMeshFile(path))
        throw AddressError(uri.text + ": is a scene, no camera: run, render and check take it");
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        throw DeviceError("cannot open " + uri.text + ": no such file", true);
    if (extension == ".oni") return openni2::openOniFile(path, rig);
    if (kinect2::isRawRecording(path)) return kinect2::openRawRecording(path, rig);
    if (extension != ".mkv")
        throw AddressError("cannot open " + uri.text + ": unknown kind of file (allowed " +
                           std::string(kKnown) + ")");
    return openKinectRecording(path, rig);
}

Input dispatch(const Uri& uri, const std::optional<calib::SensorRig>& rig) {
    constexpr std::array<std::string_view, 3> kLater{"quilt", "sbs", "idle"};
    if (uri.scheme.empty()) return openFile(uri, rig);
    if (uri.scheme == "tum") return openTum(uri, rig);
    if (uri.scheme == "seq") return openSequence(uri, rig);
    if (uri.scheme == "rgbd") return openRgbd(uri, rig);
    if (uri.scheme == "v4l2") return v4l2::openV4l2(uri, rig);
    if (uri.scheme == "kinect2") return kinect2::openKinect2(uri, rig);
    if (uri.scheme == "openni2") return openni2::openOpenNi(uri, rig);
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

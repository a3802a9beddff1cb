#include "devices/openni2/openni_input.hpp"

#include "devices/openni2/openni_source.hpp"
#include "devices/openni2/pinhole.hpp"

#include <chrono>
#include <utility>

namespace autostereo::devices::openni2 {

namespace {

bool oneOf(const Uri& uri, const std::string& key, const char* no, const char* yes) {
    const std::string text = uri.value(key);
    if (text.empty() || text == no) return false;
    if (text == yes) return true;
    throw AddressError(uri.text + ": " + key + " = '" + text + "' (allowed " + no + ", " + yes +
                       ")");
}

std::string describe(const StreamShape& shape, const char* what) {
    return std::to_string(shape.width) + "x" + std::to_string(shape.height) + " " + what + " at " +
           std::to_string(shape.fps) + " fps";
}

void checkSize(const Uri& uri, const StreamShape& shape, const calib::CameraModel& camera,
               const char* what) {
    const auto& rig = camera.intrinsics;
    if (rig.width == shape.width && rig.height == shape.height) return;
    throw DeviceError(uri.text + ": its " + what + " has " + describe(shape, "pictures") +
                      ", the rig is for " + std::to_string(rig.width) + "x" +
                      std::to_string(rig.height));
}

/// Opens one of the two streams and says how to open it again.
std::unique_ptr<OpenNiSource> openStream(const DeviceRequest& request, Reopen& reopen) {
    const Sensor main = request.sensors.front();
    auto open = [request, main] {
        auto device = std::make_unique<Device>(request);
        if (device->stream(main) == nullptr)
            throw DeviceError("openni2: " + device->uri() + " has no such stream any more");
        return std::make_unique<OpenNiSource>(std::move(device), main);
    };
    // The library stays loaded in between: drivers then hear of a device that comes back.
    reopen = [open, session = Session::get()]() -> std::unique_ptr<Source> { return open(); };
    return open();
}

} // namespace

Input openOpenNi(const Uri& uri, const std::optional<calib::SensorRig>& rig) {
    uri.allowOnly({"registered", "depth"});
    DeviceRequest request{
        uri.path, {}, oneOf(uri, "depth", "1mm", "0.1mm"), oneOf(uri, "registered", "off", "on")};
    Input input;
    input.uri = uri.text;
    const Device probe(request); // of which the sensors are asked, and which one it is
    request.uri = probe.uri();
    input.description = "OpenNI2 device " + probe.name() + " (" + probe.uri() + ")";
    calib::SensorRig nominal;
    nominal.provenance = "the fields of view that the device states";
    const auto add = [&](std::vector<Sensor> sensors, const char* what,
                         std::unique_ptr<Source>& source, Reopen& reopen, bool& live,
                         calib::CameraModel calib::SensorRig::*camera) {
        request.sensors = std::move(sensors);
        auto opened = openStream(request, reopen);
        const StreamShape& shape = *opened->device().stream(request.sensors.front());
        if (rig) checkSize(uri, shape, (*rig).*camera, what);
        nominal.*camera =
            pinhole(shape.width, shape.height, shape.horizontalFov, shape.verticalFov);
        input.description += ", " + describe(shape, what);
        if (shape.fps > 0)
            input.nominalPeriod = std::chrono::nanoseconds(1'000'000'000) / shape.fps;
        source = std::move(opened);
        live = true;
    };
    if (probe.has(Sensor::Color))
        add({Sensor::Color}, "colour", input.color, input.reopen.color, input.colorIsLive,
            &calib::SensorRig::color);
    if (probe.has(Sensor::Depth))
        add({Sensor::Depth, Sensor::Infrared}, "depth", input.depth, input.reopen.depth,
            input.depthIsLive, &calib::SensorRig::depth);
    if (!input.depth && !input.color)
        throw DeviceError("openni2: " + probe.uri() + " has neither depth nor colour");
    if (input.color && input.depth && request.registered)
        nominal.depth =
            nominal.color.resized(nominal.depth.intrinsics.width, nominal.depth.intrinsics.height);
    input.rig = rig ? *rig : nominal;
    if (!rig)
        input.warnings.push_back(uri.text + ": cameras are taken as pinholes" +
                                 (request.registered ? "" : " in one place") +
                                 ", as OpenNI2 knows no more; give --rig");
    return input;
}

} // namespace autostereo::devices::openni2

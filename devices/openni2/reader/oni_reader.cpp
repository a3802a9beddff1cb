// usage: autostereo-oni-reader FILE.oni depth|color
// Reads one stream of an OpenNI2 recording and writes its frames to standard output, in the form of
// devices/openni2/oni_wire.hpp. A process of its own, because the library's player may crash or
// hang at the end of a file. Exit status 0: all frames; 1: see standard
// output where nothing came, else standard error.

#include "devices/input.hpp"
#include "devices/openni2/oni_wire.hpp"
#include "devices/openni2/openni_source.hpp"

#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <span>
#include <string>

#include <unistd.h>

namespace {

using namespace autostereo::devices; // NOLINT(google-build-using-namespace): a program's own
using namespace autostereo::devices::openni2; // NOLINT(google-build-using-namespace)

void write(std::span<const std::byte> bytes) {
    if (!bytes.empty() && std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size())
        _exit(0); // nobody reads any more
}

template<class Header>
void writeHeader(const Header& header) {
    write(std::as_bytes(std::span(&header, 1)));
}

void writeFrame(const Frame& frame) {
    OniFrameHeader header;
    header.hasAmplitude = frame.metadata().hasAmplitude ? 1 : 0;
    header.capturedAtNs = frame.metadata().capturedAt.time_since_epoch().count();
    writeHeader(header);
    write(frame.pixels());
    write(std::as_bytes(frame.amplitude()));
}

/// Or says why not, where the parent reads it.
std::unique_ptr<Device> openRecording(const std::string& file, Sensor main) try {
    DeviceRequest request;
    request.uri = file;
    request.sensors = {main};
    if (main == Sensor::Depth) request.sensors.push_back(Sensor::Infrared);
    request.recording = true;
    auto device = std::make_unique<Device>(request);
    if (device->stream(main) == nullptr) throw DeviceError("it has no such stream", true);
    return device;
} catch (const std::exception& error) {
    std::fprintf(stdout, "%s\n", error.what());
    std::fflush(stdout);
    _exit(1);
}

int readAll(std::unique_ptr<Device> device, Sensor main) {
    const StreamShape* shape = device->stream(main);
    const int frames = shape->frames;
    writeHeader(OniStreamHeader{OniStreamHeader::kMagic, static_cast<std::int32_t>(shape->format),
                                shape->width, shape->height, shape->fps, frames, shape->depthUnitM,
                                shape->horizontalFov, shape->verticalFov});
    OpenNiSource source(std::move(device), main);
    SteadyClock clock;
    const auto seen = [&] {
        return static_cast<int>(source.counters().delivered + source.counters().damaged);
    };
    while (seen() < frames) {
        const auto result = source.read(clock.now() + std::chrono::seconds(1));
        if (const auto* frame = std::get_if<Frame>(&result)) writeFrame(*frame);
        if (const auto* lost = std::get_if<Disconnected>(&result)) throw DeviceError(lost->reason);
    }
    std::fflush(stdout);
    return 0;
}

} // namespace

int main(int argc, char** argv) try {
    const std::string stream = argc == 3 ? argv[2] : "";
    if (stream != "depth" && stream != "color") {
        std::fputs("usage: autostereo-oni-reader FILE.oni depth|color\n", stderr);
        return 2;
    }
    const Sensor sensor = stream == "depth" ? Sensor::Depth : Sensor::Color;
    const int status = readAll(openRecording(argv[1], sensor), sensor);
    _exit(status); // the library may crash while it goes
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    std::fflush(stdout);
    _exit(1);
}

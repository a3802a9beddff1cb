#include "devices/openni2/openni_device.hpp"

#include "devices/input.hpp"

#include <OniCAPI.h>
#include <OniCProperties.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

namespace autostereo::devices::openni2 {

namespace {

struct FormatName {
    OniPixelFormat theirs;
    PixelFormat ours;
    double depthUnitM;
};
constexpr std::array kDepthFormats{
    FormatName{ONI_PIXEL_FORMAT_DEPTH_1_MM, PixelFormat::Depth16, 1e-3},
    FormatName{ONI_PIXEL_FORMAT_DEPTH_100_UM, PixelFormat::Depth16, 1e-4}};
constexpr std::array kInfraredFormats{
    FormatName{ONI_PIXEL_FORMAT_GRAY16, PixelFormat::Depth16, 1e-3}};
constexpr std::array kColorFormats{FormatName{ONI_PIXEL_FORMAT_RGB888, PixelFormat::Rgb8, 1e-3},
                                   FormatName{ONI_PIXEL_FORMAT_YUV422, PixelFormat::Uyvy, 1e-3},
                                   FormatName{ONI_PIXEL_FORMAT_YUYV, PixelFormat::Yuyv, 1e-3},
                                   FormatName{ONI_PIXEL_FORMAT_GRAY8, PixelFormat::Grey8, 1e-3}};

std::span<const FormatName> formatsOf(Sensor sensor) {
    if (sensor == Sensor::Depth) return kDepthFormats;
    if (sensor == Sensor::Infrared) return kInfraredFormats;
    return kColorFormats;
}

OniSensorType typeOf(Sensor sensor) {
    if (sensor == Sensor::Depth) return ONI_SENSOR_DEPTH;
    if (sensor == Sensor::Infrared) return ONI_SENSOR_IR;
    return ONI_SENSOR_COLOR;
}

const char* nameOf(Sensor sensor) {
    if (sensor == Sensor::Depth) return "depth";
    if (sensor == Sensor::Infrared) return "infrared";
    return "colour";
}

/// How much to prefer a mode: the format we can use best, then size, then rate.
std::array<int, 3> worthOf(const OniVideoMode& mode, std::span<const FormatName> formats,
                           bool last) {
    const auto known = std::ranges::find(formats, mode.pixelFormat, &FormatName::theirs);
    if (known == formats.end()) return {};
    const auto place = static_cast<int>(known - formats.begin());
    const int rank = static_cast<int>(formats.size()) - place;
    constexpr int kMostFps = 30; // faster modes are coarser ones of the same size, or cost light
    const int fps = mode.fps <= kMostFps ? mode.fps : 1;
    return {last ? place + 1 : rank, mode.resolutionX * mode.resolutionY, fps};
}

double floatProperty(OniStreamHandle stream, int property) {
    float value = 0;
    int size = sizeof value;
    const bool known = oniStreamGetProperty(stream, property, &value, &size) == ONI_STATUS_OK;
    return known && value > 0 && value < 3.1F ? value : 0;
}

int framesIn(OniStreamHandle stream) {
    int count = 0, size = sizeof count;
    const bool known = oniStreamGetProperty(stream, ONI_STREAM_PROPERTY_NUMBER_OF_FRAMES, &count,
                                            &size) == ONI_STATUS_OK;
    return known ? std::max(count, 0) : 0;
}

} // namespace

struct Picture::Handle {
    explicit Handle(OniFrame* lent) : frame(lent) {}
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() { oniFrameRelease(frame); }
    OniFrame* frame;
};

Picture::Picture(std::unique_ptr<Handle> handle, Sensor sensor)
    : handle_(std::move(handle)), sensor_(sensor) {}
Picture::Picture(Picture&&) noexcept = default;
Picture& Picture::operator=(Picture&&) noexcept = default;
Picture::~Picture() = default;

int Picture::index() const { return handle_->frame->frameIndex; }

Duration Picture::timestamp() const {
    return std::chrono::microseconds(
        static_cast<std::int64_t>(handle_->frame->timestamp & 0xffff'ffff'ffffULL));
}

bool Picture::copyTo(const StreamShape& shape, std::span<std::byte> pixels) const {
    const OniFrame& frame = *handle_->frame;
    if (frame.width != shape.width || frame.height != shape.height || frame.data == nullptr)
        return false;
    const std::size_t row = frameBytes(shape.format, shape.width, 1);
    const auto rows = static_cast<std::size_t>(shape.height);
    if (frame.stride < 0 || frame.dataSize < 0) return false;
    const auto stride = static_cast<std::size_t>(frame.stride);
    if (stride < row || stride * (rows - 1) + row > static_cast<std::size_t>(frame.dataSize) ||
        pixels.size() < row * rows)
        return false;
    const auto* from = static_cast<const std::byte*>(frame.data);
    for (std::size_t y = 0; y < rows; ++y)
        std::memcpy(pixels.data() + y * row, from + y * stride, row);
    return true;
}

struct Device::Handles {
    Handles(Session& in, std::string name) : session(in), uri(std::move(name)) {
        const auto entered = session.enter(uri);
        if (!entered)
            throw DeviceError("openni2: " + uri + " is still open from before it was lost", true);
        losses = *entered;
    }
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;

    Session& session;
    std::string uri;
    std::uint64_t losses = 0; ///< before it was opened
    OniDeviceHandle device = nullptr;
    std::vector<OniStreamHandle> streams;
    bool recording = false;

    ~Handles() {
        for (OniStreamHandle stream : streams)
            oniStreamStop(stream);
        // The file player's thread walks through the streams once more.
        if (recording) std::this_thread::sleep_for(std::chrono::milliseconds(60));
        for (OniStreamHandle stream : streams)
            oniStreamDestroy(stream);
        if (device != nullptr) oniDeviceClose(device);
        session.leave(uri, losses);
    }
};

Device::Device(const DeviceRequest& request) : session_(Session::get()) {
    openDevice(request);
    for (const Sensor sensor : request.sensors)
        addStream(sensor, request);
    startStreams();
}

Device::~Device() = default;

void Device::openDevice(const DeviceRequest& request) {
    const auto found = session_->devices();
    if (request.uri.empty() && found.empty())
        throw DeviceError("openni2: no device found (plug one in, or install its driver in "
                          "OpenNI2/Drivers beside libOpenNI2.so.0)",
                          true);
    uri_ = request.uri.empty() ? found.front().uri : request.uri;
    handles_ = std::make_unique<Handles>(*session_, uri_);
    if (oniDeviceOpen(uri_.c_str(), &handles_->device) != ONI_STATUS_OK) {
        handles_->device = nullptr;
        throw DeviceError("openni2: cannot open " + uri_ + ": " + lastReason(),
                          std::ranges::find(found, uri_, &FoundDevice::uri) == found.end());
    }
    OniDeviceInfo info{};
    if (oniDeviceGetInfo(handles_->device, &info) == ONI_STATUS_OK)
        name_ = std::string(info.vendor) + " " + info.name;
    recording_ = handles_->recording = request.recording;
    if (recording_) return playOnceByHand();
    const auto mode =
        request.registered ? ONI_IMAGE_REGISTRATION_DEPTH_TO_COLOR : ONI_IMAGE_REGISTRATION_OFF;
    const bool set = oniDeviceSetProperty(handles_->device, ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION,
                                          &mode, sizeof mode) == ONI_STATUS_OK;
    if (request.registered && !set)
        throw DeviceError("openni2: " + uri_ +
                          " cannot register depth to colour (leave out "
                          "registered=on, give --rig)");
    registered_ = request.registered;
}

void Device::playOnceByHand() {
    constexpr float kByHand = -1; // a frame each time one is asked for: the only speed without loss
    constexpr OniBool kRepeat = FALSE;
    if (oniDeviceSetProperty(handles_->device, ONI_DEVICE_PROPERTY_PLAYBACK_SPEED, &kByHand,
                             sizeof kByHand) != ONI_STATUS_OK ||
        oniDeviceSetProperty(handles_->device, ONI_DEVICE_PROPERTY_PLAYBACK_REPEAT_ENABLED,
                             &kRepeat, sizeof kRepeat) != ONI_STATUS_OK)
        throw DeviceError("openni2: cannot play " + uri_ + " frame by frame: " + lastReason());
}

bool Device::has(Sensor sensor) const {
    return oniDeviceGetSensorInfo(handles_->device, typeOf(sensor)) != nullptr;
}

void Device::addStream(Sensor sensor, const DeviceRequest& request) {
    const OniSensorInfo* info = oniDeviceGetSensorInfo(handles_->device, typeOf(sensor));
    if (info == nullptr) return;
    const std::span modes(info->pSupportedVideoModes,
                          static_cast<std::size_t>(std::max(0, info->numSupportedVideoModes)));
    const auto formats = formatsOf(sensor);
    const bool fine = sensor == Sensor::Depth && request.fineDepth;
    const auto worth = [&](const OniVideoMode& mode) { return worthOf(mode, formats, fine); };
    const auto best = std::ranges::max_element(modes, {}, worth);
    if (best == modes.end() || worth(*best)[0] == 0)
        throw DeviceError("openni2: " + uri_ + " has no " + nameOf(sensor) +
                          " format that can be used");
    OniStreamHandle stream = nullptr;
    if (oniDeviceCreateStream(handles_->device, typeOf(sensor), &stream) != ONI_STATUS_OK)
        throw DeviceError("openni2: " + uri_ + ": cannot open its " + nameOf(sensor) +
                          " stream: " + lastReason());
    handles_->streams.push_back(stream);
    OniVideoMode mode = *best;
    const bool set = recording_ || oniStreamSetProperty(stream, ONI_STREAM_PROPERTY_VIDEO_MODE,
                                                        &mode, sizeof mode) == ONI_STATUS_OK;
    int size = sizeof mode;
    const bool told =
        oniStreamGetProperty(stream, ONI_STREAM_PROPERTY_VIDEO_MODE, &mode, &size) == ONI_STATUS_OK;
    const auto format = std::ranges::find(formats, mode.pixelFormat, &FormatName::theirs);
    constexpr int kLargest = 8192;
    if (!set || !told || format == formats.end() || mode.resolutionX > kLargest ||
        mode.resolutionY > kLargest ||
        !allowsSize(format->ours, mode.resolutionX, mode.resolutionY))
        throw DeviceError("openni2: " + uri_ + ": its " + nameOf(sensor) +
                          " stream takes no mode that it offers: " + lastReason());
    const OniBool mirrored = FALSE; // some mirror unless told otherwise; not all know the word
    static_cast<void>(
        oniStreamSetProperty(stream, ONI_STREAM_PROPERTY_MIRRORING, &mirrored, sizeof mirrored));
    shapes_.push_back({sensor, format->ours, mode.resolutionX, mode.resolutionY, mode.fps,
                       format->depthUnitM,
                       floatProperty(stream, ONI_STREAM_PROPERTY_HORIZONTAL_FOV),
                       floatProperty(stream, ONI_STREAM_PROPERTY_VERTICAL_FOV), framesIn(stream)});
}

void Device::startStreams() {
    for (std::size_t i = 0; i < shapes_.size();) {
        if (oniStreamStart(handles_->streams[i]) == ONI_STATUS_OK) {
            ++i;
            continue;
        }
        if (shapes_[i].sensor != Sensor::Infrared)
            throw DeviceError("openni2: " + uri_ + ": cannot start its " +
                              nameOf(shapes_[i].sensor) + " stream: " + lastReason());
        // One sensor behind one lens: some devices give depth or infrared.
        oniStreamDestroy(handles_->streams[i]);
        handles_->streams.erase(handles_->streams.begin() + static_cast<std::ptrdiff_t>(i));
        shapes_.erase(shapes_.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

const StreamShape* Device::stream(Sensor sensor) const {
    const auto found = std::ranges::find(shapes_, sensor, &StreamShape::sensor);
    return found == shapes_.end() ? nullptr : &*found;
}

std::optional<Picture> Device::next(Duration wait) {
    using Milliseconds = std::chrono::milliseconds;
    int which = -1;
    const auto ms =
        std::clamp(std::chrono::ceil<Milliseconds>(wait), Milliseconds(0), Milliseconds(1000));
    if (oniWaitForAnyStream(handles_->streams.data(), static_cast<int>(handles_->streams.size()),
                            &which, static_cast<int>(ms.count())) != ONI_STATUS_OK)
        return std::nullopt;
    const auto index = static_cast<std::size_t>(which);
    OniFrame* frame = nullptr;
    if (which < 0 || index >= shapes_.size() ||
        oniStreamReadFrame(handles_->streams[index], &frame) != ONI_STATUS_OK || frame == nullptr)
        return std::nullopt;
    return Picture(std::make_unique<Picture::Handle>(frame), shapes_[index].sensor);
}

bool Device::lost() const { return session_->losses(uri_) != handles_->losses; }

} // namespace autostereo::devices::openni2

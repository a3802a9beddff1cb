#include "devices/sim/openni2/simulated_streams.hpp"

#include "devices/frame_pool.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

namespace autostereo::devices::sim {

namespace {

/// A property's answer, of exactly the size that was asked for.
template<class T>
OniStatus answer(const T& value, void* data, int* size) {
    if (*size != static_cast<int>(sizeof value)) return ONI_STATUS_BAD_PARAMETER;
    std::memcpy(data, &value, sizeof value);
    return ONI_STATUS_OK;
}

std::string simulationUri() {
    const auto size = [](int width, int height) {
        return std::to_string(width) + "x" + std::to_string(height);
    };
    return "sim:room?depth=" + size(SimulatedDevice::kDepthWidth, SimulatedDevice::kDepthHeight) +
           "&color=" + size(SimulatedDevice::kColorWidth, SimulatedDevice::kColorHeight);
}

std::uint64_t microsecondsNow() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::microseconds>(now).count());
}

std::uint16_t tenths(std::uint16_t mm) {
    constexpr int kMost = 65534;
    return static_cast<std::uint16_t>(mm * 10 <= kMost ? mm * 10 : 0);
}

calib::CameraModel inColorsPlace(const calib::SensorRig& rig) {
    return rig.color.resized(SimulatedDevice::kDepthWidth, SimulatedDevice::kDepthHeight);
}

} // namespace

SimulatedStream::SimulatedStream(SimulatedDevice& device, OniSensorType sensor)
    : device_(device), sensor_(sensor), mode_(device.info(sensor).pSupportedVideoModes[0]) {}

SimulatedStream::~SimulatedStream() {
    stop();
    device_.forget(*this);
}

OniStatus SimulatedStream::start() {
    const std::lock_guard lock(device_.mutex());
    running_ = true;
    return ONI_STATUS_OK;
}

void SimulatedStream::stop() {
    const std::lock_guard lock(device_.mutex());
    running_ = false;
}

OniBool SimulatedStream::isPropertySupported(int property) {
    char room[sizeof(OniVideoMode)];
    for (int size = 1; size <= static_cast<int>(sizeof room); ++size) {
        int asked = size;
        if (getProperty(property, room, &asked) == ONI_STATUS_OK) return TRUE;
    }
    return FALSE;
}

OniStatus SimulatedStream::getProperty(int property, void* data, int* size) {
    const auto& camera = sensor_ == ONI_SENSOR_COLOR ? device_.rig().color : device_.rig().depth;
    const auto fov = [](int pixels, double focal) {
        return static_cast<float>(2 * std::atan(pixels / (2 * focal)));
    };
    switch (property) {
    case ONI_STREAM_PROPERTY_VIDEO_MODE:
        return answer(mode_, data, size);
    case ONI_STREAM_PROPERTY_MIRRORING:
        return answer(OniBool{FALSE}, data, size);
    case ONI_STREAM_PROPERTY_CROPPING: // recordings play back as no frames at all without it
        return answer(OniCropping{}, data, size);
    case ONI_STREAM_PROPERTY_MAX_VALUE: // the recorder's tables overflow without it
        return answer(int{65535}, data, size);
    case ONI_STREAM_PROPERTY_MIN_VALUE:
        return answer(int{0}, data, size);
    case ONI_STREAM_PROPERTY_HORIZONTAL_FOV:
        return answer(fov(camera.intrinsics.width, camera.intrinsics.fx), data, size);
    case ONI_STREAM_PROPERTY_VERTICAL_FOV:
        return answer(fov(camera.intrinsics.height, camera.intrinsics.fy), data, size);
    default:
        return ONI_STATUS_NOT_SUPPORTED;
    }
}

OniStatus SimulatedStream::setProperty(int property, const void* data, int size) {
    if (property == ONI_STREAM_PROPERTY_MIRRORING && size == static_cast<int>(sizeof(OniBool))) {
        OniBool mirrored = FALSE;
        std::memcpy(&mirrored, data, sizeof mirrored);
        return mirrored == FALSE ? ONI_STATUS_OK : ONI_STATUS_NOT_SUPPORTED;
    }
    if (property != ONI_STREAM_PROPERTY_VIDEO_MODE || size != static_cast<int>(sizeof mode_))
        return ONI_STATUS_NOT_SUPPORTED;
    OniVideoMode wanted;
    std::memcpy(&wanted, data, sizeof wanted);
    const OniSensorInfo& info = device_.info(sensor_);
    for (int i = 0; i < info.numSupportedVideoModes; ++i)
        if (std::memcmp(&info.pSupportedVideoModes[i], &wanted, sizeof wanted) == 0) {
            const std::lock_guard lock(device_.mutex());
            mode_ = wanted;
            return ONI_STATUS_OK;
        }
    return ONI_STATUS_NOT_SUPPORTED;
}

void SimulatedStream::show(const Frame& frame, int index, std::uint64_t microseconds) {
    if (!running_) return;
    OniFrame* picture = getServices().acquireFrame();
    if (picture == nullptr) return;
    picture->sensorType = sensor_;
    picture->videoMode = mode_;
    picture->width = mode_.resolutionX;
    picture->height = mode_.resolutionY;
    picture->timestamp = microseconds;
    picture->frameIndex = index;
    picture->croppingEnabled = FALSE;
    picture->cropOriginX = picture->cropOriginY = 0;
    picture->stride = mode_.resolutionX * (sensor_ == ONI_SENSOR_COLOR ? 3 : 2);
    fill(frame, *picture);
    raiseNewFrame(picture);
    getServices().releaseFrame(picture);
}

void SimulatedStream::fill(const Frame& frame, OniFrame& picture) const {
    if (sensor_ == ONI_SENSOR_COLOR) {
        auto* to = static_cast<std::byte*>(picture.data);
        const auto from = frame.pixels();
        for (std::size_t i = 0; i < frame.pixelCount(); ++i)
            std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(4 * i), 3, to + 3 * i);
        return;
    }
    auto* to = static_cast<std::uint16_t*>(picture.data);
    if (sensor_ == ONI_SENSOR_IR)
        std::ranges::copy(frame.amplitude(), to);
    else if (mode_.pixelFormat == ONI_PIXEL_FORMAT_DEPTH_1_MM)
        std::ranges::copy(frame.depth(), to);
    else
        std::ranges::transform(frame.depth(), to, tenths);
}

SimulatedDevice::SimulatedDevice()
    : rig_(simulatedRig(kDepthWidth, kDepthHeight, kColorWidth, kColorHeight)),
      scene_(makeScene("room", 1)), cameras_(openSimulation(simulationUri())),
      registeredCamera_(scene_, inColorsPlace(rig_), {}, 1, false) {
    const auto mode = [](OniPixelFormat format, int width, int height) {
        return OniVideoMode{format, width, height, kFps};
    };
    modes_[0] = {mode(ONI_PIXEL_FORMAT_DEPTH_1_MM, kDepthWidth, kDepthHeight),
                 mode(ONI_PIXEL_FORMAT_DEPTH_100_UM, kDepthWidth, kDepthHeight)};
    modes_[1] = {mode(ONI_PIXEL_FORMAT_GRAY16, kDepthWidth, kDepthHeight)};
    modes_[2] = {mode(ONI_PIXEL_FORMAT_RGB888, kColorWidth, kColorHeight)};
    constexpr std::array kSensors{ONI_SENSOR_DEPTH, ONI_SENSOR_IR, ONI_SENSOR_COLOR};
    for (std::size_t i = 0; i < kSensors.size(); ++i)
        infos_[i] = {kSensors[i], static_cast<int>(modes_[i].size()), modes_[i].data()};
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

SimulatedDevice::~SimulatedDevice() = default;

const OniSensorInfo& SimulatedDevice::info(OniSensorType sensor) const {
    return *std::ranges::find(infos_, sensor, &OniSensorInfo::sensorType);
}

OniStatus SimulatedDevice::getSensorInfoList(OniSensorInfo** infos, int* count) {
    *infos = infos_.data(); // the library never frees it
    *count = static_cast<int>(infos_.size());
    return ONI_STATUS_OK;
}

oni::driver::StreamBase* SimulatedDevice::createStream(OniSensorType sensor) {
    auto stream = std::make_unique<SimulatedStream>(*this, sensor);
    const std::lock_guard lock(mutex_);
    streams_.push_back(stream.get());
    return stream.release(); // until destroyStream
}

void SimulatedDevice::destroyStream(oni::driver::StreamBase* stream) {
    delete static_cast<SimulatedStream*>(stream);
}

void SimulatedDevice::forget(const SimulatedStream& stream) {
    const std::lock_guard lock(mutex_);
    std::erase(streams_, &stream);
}

OniBool SimulatedDevice::isPropertySupported(int property) {
    return property == ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION ? TRUE : FALSE;
}

OniStatus SimulatedDevice::getProperty(int property, void* data, int* size) {
    if (property != ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION) return ONI_STATUS_NOT_SUPPORTED;
    const std::lock_guard lock(mutex_);
    return answer(registration_, data, size);
}

OniStatus SimulatedDevice::setProperty(int property, const void* data, int size) {
    if (property != ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION ||
        size != static_cast<int>(sizeof registration_))
        return ONI_STATUS_NOT_SUPPORTED;
    const std::lock_guard lock(mutex_);
    std::memcpy(&registration_, data, sizeof registration_);
    return ONI_STATUS_OK;
}

void SimulatedDevice::fallSilent() {
    const std::lock_guard lock(mutex_);
    silent_ = true;
}

void SimulatedDevice::run(const std::stop_token& stop) {
    using namespace std::chrono;
    const auto start = steady_clock::now();
    for (int index = 1; !stop.stop_requested(); ++index) {
        showAll(index);
        // Late, it is no faster than its shutter.
        constexpr milliseconds kLeast{10};
        std::this_thread::sleep_until(std::max<steady_clock::time_point>(
            steady_clock::now() + kLeast, start + index * nanoseconds(1'000'000'000) / kFps));
    }
}

void SimulatedDevice::showAll(int index) {
    auto depth = cameras_.depth->read({});
    auto color = cameras_.color->read({});
    auto* depthFrame = std::get_if<Frame>(&depth);
    auto* colorFrame = std::get_if<Frame>(&color);
    const std::lock_guard lock(mutex_);
    if (silent_ || depthFrame == nullptr || colorFrame == nullptr) return;
    if (registration_ == ONI_IMAGE_REGISTRATION_DEPTH_TO_COLOR) {
        auto registered = registeredFrames_.acquire(depthFrame->metadata());
        if (!registered) return;
        registeredCamera_.expose(*registered);
        *depthFrame = std::move(*registered);
    }
    const std::uint64_t now = microsecondsNow(); // of all streams: one shutter
    for (SimulatedStream* stream : streams_)
        stream->show(stream->sensor() == ONI_SENSOR_COLOR ? *colorFrame : *depthFrame, index, now);
}

} // namespace autostereo::devices::sim

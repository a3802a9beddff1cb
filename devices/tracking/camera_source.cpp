#include "devices/tracking/camera_source.hpp"

#include "devices/nominal_camera.hpp"
#include "devices/paced_source.hpp"

#include <spdlog/spdlog.h>

#include <cmath>
#include <utility>

#include <pthread.h>

namespace autostereo::devices {

namespace {

constexpr Duration kSlice =
    std::chrono::milliseconds(50); // longest time without a look at the stop token

/// Colour alone, as if it were live.
Input colorOf(Input input, Clock& clock) {
    if (!input.color)
        throw DeviceError("viewer: " + input.uri + " has no colour picture to find eyes in");
    input.depth.reset();
    return paced(std::move(input), clock, true);
}

} // namespace

CameraSource::CameraSource(const ViewerParams& params, Input input, Clock& clock)
    : params_(params), own_(input.rig ? std::make_optional(input.rig->color) : std::nullopt),
      tracker_(params) {
    Input color = colorOf(std::move(input), clock);
    camera_.emplace("viewer-camera", std::move(color.color), std::move(color.reopen.color),
                    pictures_, bell_, clock, ReconnectParams{});
    finder_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void CameraSource::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "viewer-eyes");
    while (!stop.stop_requested()) {
        const std::uint64_t seen = bell_.count();
        lookAtNewest();
        bell_.wait(seen, kSlice);
    }
}

void CameraSource::lookAtNewest() {
    Frame newest;
    while (auto picture = pictures_.take()) {
        if (!newest.empty()) tracker_.leaveOut();
        newest = std::move(*picture);
    }
    if (newest.empty()) return;
    calib::SensorRig rig;
    rig.color = cameraOf(newest);
    tracker_.track(newest, {}, rig);
}

calib::CameraModel CameraSource::cameraOf(const Frame& picture) const {
    if (params_.camera) return *params_.camera;
    const int width = picture.metadata().width, height = picture.metadata().height;
    if (own_ && params_.fieldOfViewRad == 0) return *own_;
    calib::CameraModel camera = nominalCamera(width, height);
    if (params_.fieldOfViewRad > 0)
        camera.intrinsics.fx = camera.intrinsics.fy =
            width / (2 * std::tan(params_.fieldOfViewRad / 2));
    return camera;
}

} // namespace autostereo::devices

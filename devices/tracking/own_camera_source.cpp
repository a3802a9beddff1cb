#include "devices/tracking/own_camera_source.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include <pthread.h>

namespace autostereo::devices {

namespace {

constexpr Duration kSlice =
    std::chrono::milliseconds(50); // longest time without a look at the stop token

/// The pixels alone; empty where the pool is.
Frame copied(const Frame& frame, FramePool& pool) {
    FrameMetadata form = frame.metadata();
    form.hasAmplitude = false;
    form.encodedBytes = 0;
    auto copy = pool.acquire(form);
    if (!copy) return {};
    std::ranges::copy(frame.pixels(), copy->pixels().begin());
    return std::move(*copy);
}

} // namespace

OwnCameraSource::OwnCameraSource(const ViewerParams& params, bool hurried)
    : tracker_(params), hurried_(hurried) {
    if (!hurried) thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

OwnCameraSource::~OwnCameraSource() {
    thread_.request_stop();
    latest_.close();
}

void OwnCameraSource::useCameras(const calib::SensorRig& rig) {
    rig_ = std::make_shared<const calib::SensorRig>(rig);
}

void OwnCameraSource::saw(const RgbdFrame& frame) {
    if (!rig_) return;
    if (hurried_) return tracker_.track(frame.color, frame.depth, *rig_);
    if (busy_.load(std::memory_order_acquire)) return tracker_.leaveOut();
    Shot shot{copied(frame.color, pool_), copied(frame.depth, pool_), rig_};
    if (shot.color.empty()) return tracker_.leaveOut();
    busy_.store(true, std::memory_order_relaxed);
    latest_.put(shot);
}

void OwnCameraSource::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "viewer-eyes");
    Shot shot;
    while (!stop.stop_requested()) {
        if (!latest_.take(shot, std::chrono::steady_clock::now() + kSlice)) continue;
        tracker_.track(shot.color, shot.depth, *shot.rig);
        shot = {};
        busy_.store(false, std::memory_order_release);
    }
}

std::optional<EyeSample> OwnCameraSource::next(TimePoint now) {
    if (!waiting_) waiting_ = tracker_.take();
    if (!waiting_ || waiting_->at > now) return std::nullopt;
    return std::exchange(waiting_, std::nullopt);
}

} // namespace autostereo::devices

#include "devices/sim/depth_camera.hpp"

#include <algorithm>
#include <utility>

namespace autostereo::devices::sim {
namespace {

TofSample sampleOf(const Hit& hit) {
    return {static_cast<float>(hit.distance),
            tofAmplitude(hit.irReflectance, hit.cosine, hit.rangeM)};
}

} // namespace

DepthCamera::DepthCamera(std::shared_ptr<const Scene> scene, const calib::CameraModel& camera,
                         const calib::RigidTransform& sceneFromCamera, std::uint64_t seed,
                         bool noise)
    : scene_(std::move(scene)), intrinsics_(camera.intrinsics),
      background_(static_cast<std::size_t>(intrinsics_.width) *
                  static_cast<std::size_t>(intrinsics_.height)),
      exact_(background_.size()),
      view_(*scene_, camera, sceneFromCamera,
            [this](std::size_t pixel, const Hit& hit) { background_[pixel] = sampleOf(hit); }),
      sensor_(intrinsics_.width, intrinsics_.height, seed, noise) {}

FrameMetadata DepthCamera::shape() const noexcept {
    FrameMetadata metadata;
    metadata.format = PixelFormat::Depth16;
    metadata.width = intrinsics_.width;
    metadata.height = intrinsics_.height;
    metadata.hasAmplitude = true;
    return metadata;
}

void DepthCamera::expose(Frame& frame) noexcept {
    std::copy(background_.begin(), background_.end(), exact_.begin());
    view_.drawMoving(secondsOf(frame.metadata().capturedAt),
                     [this](std::size_t pixel, const Hit& hit) { exact_[pixel] = sampleOf(hit); });
    sensor_.measure(exact_, frame.metadata().sequence, frame.depth(), frame.amplitude());
}

} // namespace autostereo::devices::sim

#pragma once

#include "devices/sim/scene_view.hpp"
#include "devices/sim/simulated_camera.hpp"
#include "devices/sim/tof_sensor.hpp"

#include <memory>
#include <vector>

namespace autostereo::devices::sim {

/// The time-of-flight camera in front of a scene: Depth16 in millimetres and IR amplitude.
/// Draws the fixed part of the scene while it is built.
class DepthCamera final : public SimulatedCamera {
  public:
    DepthCamera(std::shared_ptr<const Scene> scene, const calib::CameraModel& camera,
                const calib::RigidTransform& sceneFromCamera, std::uint64_t seed, bool noise);

    [[nodiscard]] FrameMetadata shape() const noexcept override;
    void expose(Frame& frame) noexcept override;

  private:
    std::shared_ptr<const Scene> scene_;
    calib::Intrinsics intrinsics_;
    std::vector<TofSample> background_;
    std::vector<TofSample> exact_; ///< of the frame being exposed
    SceneView view_;               ///< fills background_ while it is built
    TofSensor sensor_;
};

} // namespace autostereo::devices::sim

#pragma once

#include "devices/sim/scene_view.hpp"
#include "devices/sim/simulated_camera.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace autostereo::devices::sim {

/// The colour camera in front of a scene: Rgba8 with a little sensor noise (sigma 1.5 of 255, as
/// gamma-encoded shot noise is about even). Draws the fixed part of the scene while it is built.
class ColorCamera final : public SimulatedCamera {
  public:
    static constexpr double kNoiseSigma = 1.5;

    ColorCamera(std::shared_ptr<const Scene> scene, const calib::CameraModel& camera,
                const calib::RigidTransform& sceneFromCamera, std::uint64_t seed, bool noise);

    [[nodiscard]] FrameMetadata shape() const noexcept override;
    void expose(Frame& frame) noexcept override;

  private:
    using Rgba = std::array<std::uint8_t, 4>;
    [[nodiscard]] static Rgba colorOf(const Hit& hit);
    void makeNoise();
    void addNoise(std::uint64_t sequence, std::span<std::byte> pixels) const;

    std::shared_ptr<const Scene> scene_;
    calib::Intrinsics intrinsics_;
    std::uint64_t seed_;
    std::vector<Rgba> background_;
    /// Noise of three channels and 0 for alpha, in turn; each row of each frame starts elsewhere in
    /// it. Empty: no noise.
    std::vector<std::int8_t> noise_;
    SceneView view_; ///< fills background_ while it is built
};

} // namespace autostereo::devices::sim

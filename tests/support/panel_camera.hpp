#pragma once

#include "calib/camera_model.hpp"
#include "calib/look.hpp"
#include "calib/rigid_transform.hpp"

#include <cstdint>
#include <random>
#include <vector>

namespace autostereo::test {

/// A camera on a tripod in front of a panel: lens distortion, perspective, defocus, vignetting,
/// light of the room on the glass, noise, eight bits of sRGB.
class PanelCamera {
  public:
    double defocusPx = 1.2;   ///< sigma
    double roomLight = 0.06;  ///< of a white panel, at the left edge; half as much at the right
    double exposure = 0.7;    ///< level of a white panel
    double readNoise = 0.002; ///< sigma, of full scale
    double shotNoise = 0.006; ///< sigma at full scale
    calib::LightModel light{0.08, 0};

    /// 27 mm equivalent, some barrel distortion.
    PanelCamera(int width, int height, std::uint32_t seed);

    [[nodiscard]] const calib::CameraModel& model() const { return camera_; }
    /// Looks at the panel's middle from `eye` (display space), its upright tilted by `rollRad`.
    void place(const glm::dvec3& eye, double rollRad);
    /// The panel showing `rgb`, as the camera's R, G, B.
    [[nodiscard]] std::vector<std::uint8_t> photograph(const calib::DisplayOptics& panel,
                                                       const std::vector<std::uint8_t>& rgb);

  private:
    calib::CameraModel camera_;
    glm::dvec3 eye_{0};
    struct Sighted {
        glm::dvec2 point; ///< of the panel's plane
        float falloff;
    };
    std::vector<Sighted> sighted_; ///< by pixel
    std::mt19937 engine_;
};

} // namespace autostereo::test

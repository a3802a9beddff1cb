#pragma once

#include "calib/calibration_pictures.hpp"
#include "calib/camera_model.hpp"
#include "calib/solve/plane_wave.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace autostereo::calibrate {

/// Gamma-encoded R, G, B, top row first, at least as large as the camera's model says.
struct ColorImage {
    int width = 0;
    int height = 0;
    std::span<const std::uint8_t> rgb;
};

/// What one camera, standing still, saw of a panel that showed `PanelBoard`, then `Fringes`.
struct PanelPhotographs {
    std::string name; ///< for messages
    ColorImage board;
    std::array<ColorImage, calib::Fringes::kSteps> fringes;
};

/// Where that camera stood, and the fringes as seen from there.
struct PanelSight {
    std::string name;
    glm::dvec3 eye{0}; ///< display space, metres
    glm::dmat3 eyeCovariance{0};
    double boardPx = 0; ///< rms of the board's corners
    PlaneWave fringes;
};

/// Camera upright to within 90 degrees. Room light, vignetting and white balance drop out of three
/// steps; the panel's and the camera's tone curves only bend the cosine. Throws Refusal where the
/// board or the fringes cannot be seen.
[[nodiscard]] PanelSight seePanel(const calib::SubpixelLayout& panel,
                                  const calib::CameraModel& camera,
                                  const PanelPhotographs& photographs);

} // namespace autostereo::calibrate

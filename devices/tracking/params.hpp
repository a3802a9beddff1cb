#pragma once

#include "calib/camera_model.hpp"
#include "devices/clock.hpp"

#include <glm/vec3.hpp>

#include <optional>
#include <string>

namespace autostereo::devices {

/// One-euro filter (Casiez, Roussel, Vogel 2012): a low pass whose cutoff rises with speed.
struct OneEuroParams {
    double cutoffHz = 4;         ///< at rest
    double cutoffPerSpeed = 40;  ///< Hz per m/s
    double velocityCutoffHz = 8; ///< of the speed itself
    /// Speeds well below are taken for noise and not followed ahead, m/s.
    double restSpeed = 0.05;

    [[nodiscard]] bool operator==(const OneEuroParams&) const = default;
};

/// Where a head tracker stands and what its numbers mean.
struct TrackerPose {
    /// Its origin in display space, metres; none: the display's nominal eye (trackers that count
    /// from where the head was when they were centred), of a camera the panel's centre.
    std::optional<glm::dvec3> originM;
    glm::dvec3 rotationRad{0};      ///< right-handed turns about the display's x, then y, then z
    glm::dvec3 scale{1, 1, -1};     ///< its x, y, z to right, up, away from the panel
    glm::dvec3 angleScale{1, 1, 1}; ///< its yaw, pitch, roll to turns right, up, right; 0: unused

    [[nodiscard]] bool operator==(const TrackerPose&) const = default;
};

/// Whose eyes a tracked display follows, and how.
struct ViewerParams {
    std::string source; ///< URI (open_eyes.hpp); empty: nobody's
    /// From a sample's stamp until the light that follows it leaves the panel, on top of its age
    /// when the panel is filled: what the tracker and the way to the glass take.
    Duration delay = std::chrono::milliseconds(30);
    double spacingM = 0.063; ///< between the eyes, where a tracker knows heads only
    OneEuroParams smoothing;
    Duration lostAfter = std::chrono::milliseconds(200); ///< without a sample
    Duration ease = std::chrono::milliseconds(500);      ///< to the nominal eyes, and back
    TrackerPose pose;
    /// Of a colour camera that is a tracker: its calibration, or what it sees from left to right
    /// (0: not known); neither: what comes with it.
    std::optional<calib::CameraModel> camera;
    double fieldOfViewRad = 0;

    [[nodiscard]] bool operator==(const ViewerParams&) const = default;
};

} // namespace autostereo::devices

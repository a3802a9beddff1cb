#pragma once

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <limits>
#include <optional>
#include <string>

namespace autostereo::calib {

/// Pinhole part of a camera, in pixels; the centre of the first pixel is (0, 0), as in OpenCV.
struct Intrinsics {
    int width = 0;
    int height = 0;
    double fx = 0, fy = 0;
    double cx = 0, cy = 0;

    [[nodiscard]] bool operator==(const Intrinsics&) const = default;
};

/// Brown–Conrady distortion in the rational 8-parameter form, OpenCV's names. All zero: none.
/// Beyond `metricRadius` (distance from the axis on the z = 1 plane) the model is not defined.
struct Distortion {
    double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0, k4 = 0, k5 = 0, k6 = 0;
    double metricRadius = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool operator==(const Distortion&) const = default;
};

/// One camera, both directions, in double precision. x right, y down, z forward.
/// Reentrant; fails by returning nothing (behind the camera, outside the model's valid radius,
/// or no convergence), never by throwing.
struct CameraModel {
    Intrinsics intrinsics;
    Distortion distortion;

    [[nodiscard]] bool operator==(const CameraModel&) const = default;
    /// Pixel in which a point (metres, camera frame) is seen.
    [[nodiscard]] std::optional<glm::dvec2> project(const glm::dvec3& point) const;
    /// Direction (x/z, y/z) that a pixel sees; Newton's method, at most 20 steps.
    [[nodiscard]] std::optional<glm::dvec2> unproject(const glm::dvec2& pixel) const;

    /// The same camera read out at another size (both axes scaled about the image's edges).
    [[nodiscard]] CameraModel resized(int width, int height) const;
};

/// Undistorted (x/z, y/z) -> distorted; the forward model of OpenCV's projectPoints.
[[nodiscard]] glm::dvec2 distort(const Distortion& distortion, const glm::dvec2& ray);
/// Its derivative by the ray (symmetric).
[[nodiscard]] glm::dmat2 distortSlope(const Distortion& distortion, const glm::dvec2& ray);

/// What is wrong with a camera as one phrase ("fx = 0 (allowed > 0)"), or nothing.
[[nodiscard]] std::optional<std::string> problemWith(const CameraModel& camera);

} // namespace autostereo::calib

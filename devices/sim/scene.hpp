#pragma once

#include "devices/sim/body.hpp"

#include <functional>
#include <span>
#include <vector>

namespace autostereo::devices::sim {

/// What a ray sees.
struct Hit {
    double distance = kNoHit; ///< in lengths of the ray's direction
    double rangeM = kNoHit;   ///< the same in metres
    glm::dvec3 point{0.0};    ///< metres
    glm::dvec3 color{0.0};    ///< gamma-encoded, 0..255, not rounded; the same from everywhere
    double irReflectance = 0; ///< towards the sensor; above 1 in a glossy highlight
    double cosine = 0;        ///< of the angle of incidence, 0..1
};

/// Colour and infrared of a body where a ray meets it.
[[nodiscard]] Hit shade(const Body& body, const Ray& ray, double distance);

/// A scene at one moment. Refers to its Scene, which must outlive it.
class Snapshot {
  public:
    Snapshot(std::span<const Body> fixed, std::vector<Body> moving)
        : fixed_(fixed), moving_(std::move(moving)) {}
    [[nodiscard]] Hit trace(const Ray& ray) const;
    [[nodiscard]] std::span<const Body> fixed() const { return fixed_; }
    [[nodiscard]] std::span<const Body> moving() const { return moving_; }

  private:
    std::span<const Body> fixed_;
    std::vector<Body> moving_;
};

/// A closed room of solid bodies in the colour camera's frame of reference (metres, x right,
/// y down, z forward), some of them moving as a pure function of time. The exact truth behind the
/// simulated sensors: any ray from any place hits something. Surfaces are Lambertian in colour, so
/// a point looks the same from every viewpoint. Immutable, reentrant.
class Scene {
  public:
    using Motion = std::function<std::vector<Body>(double timeSeconds)>;
    explicit Scene(std::vector<Body> fixed, Motion moving = {})
        : fixed_(std::move(fixed)), moving_(std::move(moving)) {}

    [[nodiscard]] Snapshot at(double timeSeconds) const {
        return {fixed_, moving_ ? moving_(timeSeconds) : std::vector<Body>{}};
    }
    /// One ray at one moment; for many rays take `at` once.
    [[nodiscard]] Hit trace(const glm::dvec3& origin, const glm::dvec3& direction,
                            double timeSeconds) const {
        return at(timeSeconds).trace({origin, direction});
    }

  private:
    std::vector<Body> fixed_;
    Motion moving_;
};

} // namespace autostereo::devices::sim

#include "devices/sim/scene.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace autostereo::devices::sim {
namespace {

// A large soft lamp below the ceiling, up left in front of the scene; warm light, cool shade.
constexpr glm::dvec3 kLamp{-0.9, -1.3, 0.2};
constexpr glm::dvec3 kAmbient{0.60, 0.61, 0.65};
constexpr glm::dvec3 kLight{0.52, 0.49, 0.42};

/// Lambert with the soft terminator of an extended light, so that no edge appears where it ends.
glm::dvec3 lightAt(const glm::dvec3& point, const glm::dvec3& normal) {
    const glm::dvec3 toLamp = kLamp - point;
    const double distance = std::max(glm::length(toLamp), 0.1);
    const double facing = glm::dot(normal, toLamp) / distance;
    const double wrapped = std::max(0.0, (facing + 0.35) / 1.35);
    const double falloff = 1.6 / (1.0 + 0.09 * distance * distance);
    return kAmbient + kLight * (wrapped * wrapped * falloff);
}

} // namespace

Hit shade(const Body& body, const Ray& ray, double distance) {
    const auto& [rotation, centre] = body.sceneFromBody;
    Hit hit;
    hit.distance = distance;
    hit.point = ray.origin + ray.direction * distance;
    const glm::dvec3 position = (hit.point - centre) * rotation;
    const glm::dvec3 outward = normalAt(body, position);
    const Paint paint = body.material.texture(body.material, {position, outward, body.size});

    glm::dvec3 normal = rotation * outward;
    const double length = glm::length(ray.direction);
    hit.rangeM = distance * length;
    const double facing = glm::dot(normal, ray.direction) / length;
    if (facing > 0) normal = -normal; // seen from within
    hit.cosine = std::min(std::abs(facing), 1.0);
    hit.color = glm::clamp(paint.color * lightAt(hit.point, normal), 0.0, 255.0);
    // The infrared source sits beside the lens: a mirror-like part comes back only head on.
    constexpr double kShininess = 120.0;
    hit.irReflectance = paint.irReflectance;
    if (body.material.gloss > 0) {
        hit.irReflectance += body.material.gloss * std::pow(hit.cosine, kShininess);
    }
    return hit;
}

Hit Snapshot::trace(const Ray& ray) const {
    double nearest = kNoHit;
    const Body* seen = nullptr;
    for (const auto& bodies : {fixed_, std::span<const Body>(moving_)}) {
        for (const Body& body : bodies) {
            const double distance = BodyFromPoint(body, ray.origin).distanceAlong(ray.direction);
            if (distance < nearest) {
                nearest = distance;
                seen = &body;
            }
        }
    }
    return seen != nullptr ? shade(*seen, ray, nearest) : Hit{};
}

} // namespace autostereo::devices::sim

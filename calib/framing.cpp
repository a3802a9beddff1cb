#include "calib/framing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace autostereo::calib {

namespace {

struct Box {
    double left = -std::numeric_limits<double>::infinity();
    double right = std::numeric_limits<double>::infinity();
    double top = -std::numeric_limits<double>::infinity();
    double bottom = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool empty() const { return !(left < right && top < bottom); }
};

/// Shrinks `box` to what `camera` covers at distance `z` of the colour camera, seen from there. The
/// picture's edges are sampled: distortion and tilt bend them.
void coverAt(const CameraModel& camera, const RigidTransform& colorFromCamera, double z, Box& box) {
    constexpr int kSamples = 33;
    const double right = camera.intrinsics.width - 1, bottom = camera.intrinsics.height - 1;
    const auto seen = [&](double x, double y) -> std::optional<glm::dvec2> {
        const auto ray = camera.unproject({x, y});
        if (!ray) return std::nullopt;
        const glm::dvec3 along = colorFromCamera.rotation * glm::dvec3{*ray, 1};
        const glm::dvec3& start = colorFromCamera.translation;
        const double reach = (z - start.z) / along.z; // to the plane at z of the colour camera
        if (!(along.z > 0 && reach > 0)) return std::nullopt;
        return glm::dvec2{start + reach * along} / z;
    };
    for (int i = 0; i < kSamples; ++i) {
        const double along = static_cast<double>(i) / (kSamples - 1);
        if (const auto p = seen(0, along * bottom)) box.left = std::max(box.left, p->x);
        if (const auto p = seen(right, along * bottom)) box.right = std::min(box.right, p->x);
        if (const auto p = seen(along * right, 0)) box.top = std::max(box.top, p->y);
        if (const auto p = seen(along * right, bottom)) box.bottom = std::min(box.bottom, p->y);
    }
}

glm::dmat2 uprightFromCamera(const FramingChoice& choice) {
    constexpr glm::dmat2 kQuarterTurn{0, 1, -1, 0}; // x right -> down, y down -> left
    constexpr glm::dmat2 kMirror{-1, 0, 0, 1};
    glm::dmat2 turn{1.0};
    for (int i = 0; i < choice.quarterTurns; ++i)
        turn = kQuarterTurn * turn;
    return choice.mirror ? kMirror * turn : turn;
}

Box turned(const Box& box, const glm::dmat2& turn) {
    const glm::dvec2 a = turn * glm::dvec2{box.left, box.top};
    const glm::dvec2 b = turn * glm::dvec2{box.right, box.bottom};
    return {std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y)};
}

/// A lens model that ends inside the picture leaves sides without a ray: those end where it does.
void boundByModel(const Distortion& lens, Box& box) {
    constexpr double kWithoutRadius = 1; // 45 degrees
    const double reach =
        std::isfinite(lens.metricRadius) ? lens.metricRadius / std::sqrt(2) : kWithoutRadius;
    for (double* side : {&box.left, &box.right, &box.top, &box.bottom})
        if (!std::isfinite(*side)) *side = std::copysign(reach, *side);
}

} // namespace

Framing framePanel(const SensorRig& rig, double panelAspect, double overscan, double focusM,
                   const FramingChoice& choice) {
    constexpr double kFarM = 100;    // parallax between the cameras is gone
    const double nearM = focusM / 2; // what stands nearer may leave the edge uncovered
    Box color;
    coverAt(rig.color, RigidTransform{}, 1, color);
    boundByModel(rig.color.distortion, color);
    Box box = color;
    for (const double z : {nearM, focusM, kFarM})
        coverAt(rig.depth, rig.colorFromDepth, z, box);
    if (box.empty()) box = color; // cameras that look past each other: show the colour picture
    const glm::dmat2 upright = uprightFromCamera(choice);
    box = turned(box, upright);
    const double spread = 1 + 2 * overscan;
    const double width =
        std::min((box.right - box.left) / spread, (box.bottom - box.top) * panelAspect) /
        choice.zoom;
    const double height = width / panelAspect;
    const double spareX = box.right - box.left - spread * width;
    const double spareY = box.bottom - box.top - height;
    return {(box.left + box.right - width + choice.pan.x * spareX) / 2,
            (box.top + box.bottom + height - choice.pan.y * spareY) / 2, width, height, upright};
}

} // namespace autostereo::calib

#include "gpu/scene/scene_placement.hpp"

#include "calib/disparity_law.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autostereo::gpu {

glm::dmat3 uprightTurn(SceneUp up) {
    if (up == SceneUp::Y) return glm::dmat3(1);
    return {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}; // y goes away from the viewer, z up
}

glm::dmat4 ScenePlacement::transform(const SceneParams& params, double seconds) const {
    const double turns = params.turnS == 0 ? 0 : seconds / params.turnS;
    const double angle = params.startRad + 2 * std::numbers::pi * (turns - std::floor(turns));
    const glm::dmat4 tilted = glm::rotate(glm::dmat4(1), params.tiltRad, glm::dvec3(1, 0, 0));
    const glm::dmat4 turned = glm::rotate(tilted, angle, glm::dvec3(0, 1, 0));
    return glm::translate(glm::scale(turned, glm::dvec3(scale)), -middle) *
           glm::dmat4(uprightTurn(params.up));
}

ScenePlacement scenePlacement(const devices::mesh::MeshExtent& extent, const SceneParams& params,
                              const calib::DisplayProfile& display, double panelAspect) {
    const glm::dvec3 half = (extent.high - extent.low) / 2.0;
    const double around = extent.around;
    const double cosine = std::cos(params.tiltRad), sine = std::abs(std::sin(params.tiltRad));
    const double tall = half.y * cosine + around * sine;
    const double deep = half.y * sine + around * cosine;
    const double width = display.widthM, height = display.widthM / panelAspect;

    ScenePlacement placement;
    placement.middle = extent.middle();
    placement.scale = params.share / 2 *
                      std::min(around > 0 ? width / around : height / tall,
                               tall > 0 ? height / tall : width / around);
    placement.radiusM = placement.scale * around;
    placement.heightM = placement.scale * tall;
    const calib::DisparityLaw law = calib::disparityLaw(display, 0, 1, 1);
    // A display for one eye in one place has no budget to keep, but the eye stays outside.
    const double most = display.viewingDistanceM / 2;
    const double nearest = std::min(law.heightAt(law.nearest), most);
    const double farthest = std::max(law.heightAt(law.farthest), -most);
    const double depth = placement.scale * deep;
    // Nobody sees a thousandth, but what is nearer still hides what is farther.
    constexpr double kFlat = 1e-3;
    placement.flattening =
        std::max(kFlat, std::min({params.depthScale, nearest / depth, -farthest / depth}));
    placement.nearM = depth * placement.flattening;
    placement.farM = -placement.nearM;
    return placement;
}

} // namespace autostereo::gpu

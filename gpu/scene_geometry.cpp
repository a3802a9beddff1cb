#include "gpu/scene_geometry.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace autostereo::gpu {

namespace {

std::vector<double> depthsInside(const devices::Frame& depth, const calib::SensorRig& rig,
                                 const CountRange& range, int left, int top, int right,
                                 int bottom) {
    std::vector<double> found;
    const devices::FrameMetadata& form = depth.metadata();
    const calib::CameraModel camera = rig.depth.resized(form.width, form.height);
    for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) {
            const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(form.width) +
                               static_cast<std::size_t>(x);
            const std::uint32_t count = depth.depth()[index];
            if (count < range.nearest || count > range.farthest) continue;
            const auto ray = camera.unproject({x, y});
            if (!ray) continue;
            const double z = count * form.depthUnitM;
            const double seen = (rig.colorFromDepth * glm::dvec3{ray->x * z, ray->y * z, z}).z;
            if (seen > 0) found.push_back(seen); // else behind the colour camera
        }
    }
    return found;
}

} // namespace

CountRange countRange(const DepthMeshParams& mesh, double depthUnitM) {
    constexpr double kLargest = 65534; // 65535 means "no measurement", as 0 does
    constexpr double kRounding = 1e-6; // counts: 1.001 / 0.001 is a little more than 1001
    const double nearest =
        std::clamp(std::ceil(mesh.nearestM / depthUnitM - kRounding), 1.0, kLargest);
    const double farthest =
        std::clamp(std::floor(mesh.farthestM / depthUnitM + kRounding), nearest, kLargest);
    return {static_cast<std::uint32_t>(nearest), static_cast<std::uint32_t>(farthest)};
}

std::optional<double> medianDepth(const devices::Frame& depth, const calib::SensorRig& rig,
                                  const DepthMeshParams& mesh) {
    const int width = depth.metadata().width, height = depth.metadata().height;
    const CountRange range = countRange(mesh, depth.metadata().depthUnitM);
    std::vector<double> depths = depthsInside(depth, rig, range, width / 3, height / 3,
                                              width - width / 3, height - height / 3);
    if (depths.empty()) depths = depthsInside(depth, rig, range, 0, 0, width, height);
    if (depths.empty()) return std::nullopt;
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), middle, depths.end());
    return *middle;
}

SceneGeometry sceneGeometry(const calib::SensorRig& rig, const calib::DisplayProfile& display,
                            const PipelineParams& params, double panelAspect, double focusM) {
    constexpr double kFollowedReach = 3; // half spacings of eyes to each side: some 95 mm
    const bool follows = params.synthesis.followEyes;
    const double overscan =
        std::max(-display.disparityFar, display.disparityNear) * (follows ? kFollowedReach : 1);
    SceneGeometry geometry;
    geometry.framing = calib::framePanel(rig, panelAspect, overscan, focusM, params.framing);
    geometry.law = calib::disparityLaw(display, focusM, geometry.framing.width * focusM,
                                       params.budget.depthScale.value_or(1));
    geometry.grid = calib::cyclopeanGrid(geometry.framing, rig.depth, params.fusion.density,
                                         params.fusion.mostTexels, overscan,
                                         follows ? overscan * panelAspect : 0);
    geometry.cutM = params.backdrop.cutM;
    return geometry;
}

double relativeScale(const SceneGeometry& geometry, const calib::DisplayProfile& display) {
    return geometry.law.scale * geometry.framing.width * geometry.law.focusM / display.widthM;
}

SceneGeometry movedCameraGeometry(const calib::SensorRig& rig, glm::dvec3 offset) {
    constexpr double kMargin = 0.25;   // of the picture, for what comes into view
    constexpr double kInfinityM = 1e6; // d = t / z - t / infinity
    constexpr double kMostDisparity = 1e3;
    const calib::Intrinsics& pixels = rig.color.intrinsics;
    const auto margin = [&](int side, bool moves) {
        return moves ? static_cast<int>(std::ceil(kMargin * side)) : 0;
    };
    const int across = margin(pixels.width, offset.x != 0 || offset.z != 0);
    const int along = margin(pixels.height, offset.y != 0 || offset.z != 0);
    SceneGeometry geometry;
    geometry.framing = {(-0.5 - pixels.cx) / pixels.fx,
                        (pixels.height - 0.5 - pixels.cy) / pixels.fy, pixels.width / pixels.fx,
                        pixels.height / pixels.fy, glm::dmat2{1.0}};
    geometry.grid = {pixels.width + 2 * across, pixels.height + 2 * along,
                     static_cast<double>(across) / pixels.width,
                     static_cast<double>(along) / pixels.height};
    geometry.law.focusM = geometry.law.viewerDistanceM = kInfinityM;
    geometry.law.fanHalfWidth = glm::length(offset) / (geometry.framing.width * kInfinityM);
    geometry.law.farthest = -kMostDisparity;
    geometry.law.nearest = kMostDisparity;
    return geometry;
}

} // namespace autostereo::gpu

#include "devices/kinect2/mirror.hpp"

#include <algorithm>
#include <cstddef>

namespace autostereo::devices::kinect2 {

namespace {

calib::CameraModel mirrored(calib::CameraModel camera) {
    camera.intrinsics.cx = camera.intrinsics.width - 1 - camera.intrinsics.cx;
    camera.distortion.p2 = -camera.distortion.p2; // odd in x; the other terms are even
    return camera;
}

} // namespace

calib::SensorRig mirrored(const calib::SensorRig& rig) {
    calib::SensorRig result = rig;
    result.depth = mirrored(rig.depth);
    result.color = mirrored(rig.color);
    // S R S and S t with S = diag(-1, 1, 1).
    const glm::dvec3 flip(-1, 1, 1);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            result.colorFromDepth.rotation[column][row] *= flip[column] * flip[row];
    result.colorFromDepth.translation *= flip;
    return result;
}

void mirrorRows(std::span<std::uint32_t> pixels, int width) {
    const auto columns = static_cast<std::size_t>(width);
    for (; pixels.size() >= columns; pixels = pixels.subspan(columns))
        std::ranges::reverse(pixels.first(columns));
}

} // namespace autostereo::devices::kinect2

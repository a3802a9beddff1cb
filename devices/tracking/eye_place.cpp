#include "devices/tracking/eye_place.hpp"

#include "devices/tracking/head_pose.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace autostereo::devices {

namespace {

/// The band about the eyes, of their spacing: from temple to temple, from brow to cheekbone.
constexpr double kBandHalfWidth = 0.8, kBandHalfHeight = 0.35;
constexpr int kMostAcross = 48; ///< samples of the band, each way
constexpr std::size_t kLeastSamples = 12;
constexpr double kLeastShare = 2.0 / 3, kMostShare = 4.0 / 3; ///< of the depth that is expected

std::optional<glm::dvec3> direction(const calib::CameraModel& camera, const glm::dvec2& pixel) {
    const auto ray = camera.unproject(pixel);
    if (!ray) return std::nullopt;
    return glm::normalize(glm::dvec3{*ray, 1});
}

/// Pixels from `least` to `most`, every `step`-th.
struct Span {
    int least, most, step;
};

Span span(double middle, double half, int size) {
    const double least = std::clamp(middle - half, 0.0, static_cast<double>(size));
    const double most = std::clamp(middle + half, -1.0, size - 1.0);
    return {static_cast<int>(least), static_cast<int>(most),
            std::max(1, static_cast<int>(2 * half) / kMostAcross)};
}

/// Counts to depths along the colour camera's axis.
class Depths {
  public:
    Depths(const Frame& depth, const calib::SensorRig& rig)
        : depth_(depth),
          camera_(rig.depth.resized(depth.metadata().width, depth.metadata().height)),
          colorFromDepth_(rig.colorFromDepth) {}

    [[nodiscard]] const calib::CameraModel& camera() const { return camera_; }
    [[nodiscard]] std::optional<double> at(int column, int row) const {
        const std::uint16_t count =
            depth_.depth()[static_cast<std::size_t>(row) *
                               static_cast<std::size_t>(depth_.metadata().width) +
                           static_cast<std::size_t>(column)];
        if (count == 0 || count == 0xffff) return std::nullopt;
        const auto ray = camera_.unproject({column, row});
        if (!ray) return std::nullopt;
        return (colorFromDepth_ * (count * depth_.metadata().depthUnitM * glm::dvec3{*ray, 1})).z;
    }

  private:
    const Frame& depth_;
    calib::CameraModel camera_;
    calib::RigidTransform colorFromDepth_;
};

} // namespace

std::optional<calib::EyePair> eyesBySpacing(const calib::CameraModel& camera,
                                            const PupilPair& pupils, double spacingM) {
    const auto left = direction(camera, pupils.left), right = direction(camera, pupils.right);
    if (!left || !right) return std::nullopt;
    const double apart = glm::length(*left - *right);
    if (!(apart > 0)) return std::nullopt;
    return calib::EyePair{*left * (spacingM / apart), *right * (spacingM / apart)};
}

calib::EyePair movedTo(const calib::EyePair& eyes, double depthM) {
    const double share = depthM / eyes.middle().z;
    return {eyes.left * share, eyes.right * share};
}

std::optional<double> measuredDepth(const Frame& depth, const calib::SensorRig& rig,
                                    const calib::EyePair& eyes) {
    const Depths depths(depth, rig);
    const glm::dvec3 middle = rig.colorFromDepth.inverse() * eyes.middle();
    const auto seen = depths.camera().project(middle);
    if (!seen) return std::nullopt;
    const double spacing =
        depths.camera().intrinsics.fx * glm::length(eyes.left - eyes.right) / middle.z;
    const auto columns = span(seen->x, kBandHalfWidth * spacing, depth.metadata().width);
    const auto rows = span(seen->y, kBandHalfHeight * spacing, depth.metadata().height);
    std::vector<double> found;
    for (int row = rows.least; row <= rows.most; row += rows.step)
        for (int column = columns.least; column <= columns.most; column += columns.step)
            if (const auto z = depths.at(column, row);
                z && *z > kLeastShare * eyes.middle().z && *z < kMostShare * eyes.middle().z)
                found.push_back(*z);
    if (found.size() < kLeastSamples) return std::nullopt;
    const auto median = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
    std::ranges::nth_element(found, median);
    return *median;
}

calib::EyePair inDisplaySpace(const calib::EyePair& eyes, const TrackerPose& pose) {
    const auto shown = [&](const glm::dvec3& eye) {
        return pose.originM.value_or(glm::dvec3{0}) +
               turned({-eye.x, -eye.y, eye.z}, pose.rotationRad);
    };
    return {shown(eyes.left), shown(eyes.right)};
}

} // namespace autostereo::devices

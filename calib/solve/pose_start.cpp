#include "calib/solve/pose_start.hpp"

#include <opencv2/calib3d.hpp>

#include <cmath>

namespace autostereo::calibrate {

namespace {

calib::RigidTransform transformOf(const cv::Vec3d& turn, const cv::Vec3d& shift) {
    cv::Matx33d rows;
    cv::Rodrigues(turn, rows);
    calib::RigidTransform result;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            result.rotation[column][row] = rows(row, column);
        result.translation[row] = shift[row];
    }
    return result;
}

bool isFinite(const cv::Vec3d& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

/// Points and the rays (x/z, y/z) that their pixels stand for: OpenCV then needs no lens model.
struct Rays {
    std::vector<cv::Point3d> points;
    std::vector<cv::Point2d> rays;
    std::vector<std::size_t> places; ///< in the caller's list; pixels without a ray are left out

    void add(const calib::CameraModel& camera, const glm::dvec3& point, const glm::dvec2& pixel,
             std::size_t place) {
        const auto ray = camera.unproject(pixel);
        if (!ray) return;
        points.emplace_back(point.x, point.y, point.z);
        rays.emplace_back(ray->x, ray->y);
        places.push_back(place);
    }
};

} // namespace

std::optional<calib::CameraModel>
startingCamera(const Board& board, std::span<const BoardView> views, int width, int height) {
    std::vector<std::vector<cv::Point3f>> points(views.size());
    std::vector<std::vector<cv::Point2f>> pixels(views.size());
    for (std::size_t v = 0; v < views.size(); ++v)
        for (std::size_t i = 0; i < views[v].size(); ++i) {
            const glm::vec3 corner(board.corner(views[v].ids[i]));
            const glm::vec2 pixel(views[v].pixels[i]);
            points[v].emplace_back(corner.x, corner.y, corner.z);
            pixels[v].emplace_back(pixel.x, pixel.y);
        }
    const cv::Matx33d k = cv::initCameraMatrix2D(points, pixels, {width, height});
    calib::CameraModel camera;
    camera.intrinsics = {width, height, k(0, 0), k(1, 1), (width - 1) / 2.0, (height - 1) / 2.0};
    const auto isPlausible = [&](double focal) {
        return std::isfinite(focal) && focal > 0.1 * width && focal < 20.0 * width;
    };
    if (!isPlausible(k(0, 0)) || !isPlausible(k(1, 1))) return std::nullopt;
    return camera;
}

std::optional<calib::RigidTransform> startingPose(const calib::CameraModel& camera,
                                                  const Board& board, const BoardView& view) try {
    Rays rays;
    for (std::size_t i = 0; i < view.size(); ++i)
        rays.add(camera, board.corner(view.ids[i]), view.pixels[i], i);
    cv::Vec3d turn, shift;
    if (rays.points.size() < 4 ||
        !cv::solvePnP(rays.points, rays.rays, cv::Matx33d::eye(), cv::noArray(), turn, shift, false,
                      cv::SOLVEPNP_IPPE) ||
        !isFinite(turn) || !isFinite(shift) || !(shift[2] > 0))
        return std::nullopt;
    return transformOf(turn, shift);
} catch (const cv::Exception&) { // corners in line
    return std::nullopt;
}

std::optional<RansacPose> ransacPose(const calib::CameraModel& camera,
                                     std::span<const PointPixel> pairs, double tolerancePx) try {
    constexpr std::size_t kFewest = 6;
    constexpr int kTries = 2000; // 30 % outliers: a clean set of four in every fourth
    Rays rays;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        rays.add(camera, pairs[i].point, pairs[i].pixel, i);
    if (rays.points.size() < kFewest) return std::nullopt;
    cv::setRNGSeed(1);
    cv::Vec3d turn, shift;
    std::vector<int> inliers;
    const double tolerance = tolerancePx / camera.intrinsics.fx;
    if (!cv::solvePnPRansac(rays.points, rays.rays, cv::Matx33d::eye(), cv::noArray(), turn, shift,
                            false, kTries, static_cast<float>(tolerance), 0.9999, inliers,
                            cv::SOLVEPNP_EPNP) ||
        inliers.size() < kFewest || !isFinite(turn) || !isFinite(shift))
        return std::nullopt;
    RansacPose pose{transformOf(turn, shift), {}};
    for (const int place : inliers)
        pose.inliers.push_back(rays.places[static_cast<std::size_t>(place)]);
    return pose;
} catch (const cv::Exception&) { // points in one place or in line
    return std::nullopt;
}

} // namespace autostereo::calibrate

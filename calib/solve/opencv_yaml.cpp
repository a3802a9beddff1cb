#include "calib/solve/opencv_yaml.hpp"

#include <opencv2/core.hpp>

namespace autostereo::calibrate {

namespace {

void writeCamera(cv::FileStorage& storage, const std::string& number,
                 const calib::CameraModel& camera) {
    const calib::Intrinsics& i = camera.intrinsics;
    const calib::Distortion& k = camera.distortion;
    const cv::Matx33d matrix(i.fx, 0, i.cx, 0, i.fy, i.cy, 0, 0, 1);
    const cv::Matx<double, 1, 8> terms(k.k1, k.k2, k.p1, k.p2, k.k3, k.k4, k.k5, k.k6);
    storage << "size" + number << cv::Size(i.width, i.height);
    storage << "M" + number << cv::Mat(matrix) << "D" + number << cv::Mat(terms);
}

} // namespace

std::string openCvYaml(const std::optional<calib::CameraModel>& depth,
                       const std::optional<calib::CameraModel>& color,
                       const std::optional<calib::RigidTransform>& colorFromDepth) {
    cv::FileStorage storage("yaml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY |
                                        cv::FileStorage::FORMAT_YAML);
    if (depth) writeCamera(storage, "1", *depth);
    if (color) writeCamera(storage, "2", *color);
    if (colorFromDepth) {
        cv::Matx33d rotation;
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                rotation(row, column) = colorFromDepth->rotation[column][row];
        const glm::dvec3& t = colorFromDepth->translation;
        storage << "R" << cv::Mat(rotation) << "T" << cv::Mat(cv::Vec3d(t.x, t.y, t.z));
    }
    return storage.releaseAndGetString();
}

} // namespace autostereo::calibrate

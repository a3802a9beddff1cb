#pragma once

#include "calib/sensor_rig.hpp"
#include "calib/solve/camera_solver.hpp"
#include "calib/solve/registration_error.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace autostereo::calibrate {

/// What two cameras saw of a board: each camera's own views, and which of them are of one moment.
struct RigViews {
    std::vector<BoardView> depth; ///< infrared picture of the depth camera
    std::vector<BoardView> color;
    std::vector<std::pair<std::size_t, std::size_t>> pairs; ///< places in `depth` and `color`
};

struct PictureSizes {
    int depthWidth = 0, depthHeight = 0;
    int colorWidth = 0, colorHeight = 0;
};

struct RigCalibration {
    CameraCalibration depth; ///< camera and half95: after the joint refinement
    CameraCalibration color;
    calib::RigidTransform colorFromDepth;
    glm::dvec3 turn95Rad{0}; ///< half the 95 % interval of the rotation vector
    glm::dvec3 shift95M{0};
    double separateRmsPx = 0; ///< both cameras' numbers as found on their own
    double jointRmsPx = 0;    ///< everything refined together
    std::vector<ViewScore> pairs;
    std::vector<RegistrationError> registration;
    RigFreedom freedom; ///< what `registration` follows from

    [[nodiscard]] calib::SensorRig rig(const std::string& provenance) const {
        return {depth.camera, color.camera, colorFromDepth, provenance};
    }
};

/// Both cameras on their own (as `calibrateCamera`), the transform between them from the pairs,
/// then all refined together: residuals weigh by each camera's own noise. Pairs that fit far worse
/// than the others (a board that moved between the two pictures) are dropped by name. Throws
/// Refusal, naming the camera, where the views cannot support it.
[[nodiscard]] RigCalibration calibrateRig(const Board& board, const RigViews& views,
                                          const PictureSizes& sizes);

} // namespace autostereo::calibrate

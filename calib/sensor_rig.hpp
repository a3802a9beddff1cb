#pragma once

#include "calib/camera_model.hpp"
#include "calib/rigid_transform.hpp"

#include <string>

namespace autostereo::calib {

/// Both cameras and how they stand to each other. The colour camera is the frame of reference of
/// everything after the mesh (its position is the centre of the fan of views).
struct SensorRig {
    CameraModel depth;
    CameraModel color;
    RigidTransform colorFromDepth;
    std::string provenance; ///< where the numbers come from, for logs and reports
    double colorLateS = 0;  ///< stamps of colour minus stamps of depth, of one moment
};

} // namespace autostereo::calib

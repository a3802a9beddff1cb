#include "devices/nominal_camera.hpp"

namespace autostereo::devices {

calib::CameraModel nominalCamera(int width, int height) {
    constexpr double kFocalPerWidth = 0.82;
    calib::CameraModel camera;
    camera.intrinsics = {width,
                         height,
                         kFocalPerWidth * width,
                         kFocalPerWidth * width,
                         (width - 1) / 2.0,
                         (height - 1) / 2.0};
    return camera;
}

} // namespace autostereo::devices

#pragma once

#include "calib/camera_model.hpp"
#include "devices/frame.hpp"

#include <vector>

#include <glm/vec3.hpp>

namespace autostereo::devices {

/// A grey picture of a depth frame, for sensors without colour: the surface lit by a lamp at the
/// camera (Lambert), fading with the distance; black where there is no measurement. The normals
/// come from the neighbours' points, of the same surface only. Thread-bound.
class GreyPicture {
  public:
    explicit GreyPicture(calib::CameraModel camera) : camera_(camera) {}

    /// `color` has the size of `depth`, which need not be the camera's nominal one.
    void paint(const Frame& depth, Frame& color);

  private:
    void lookUpRays(int width, int height);

    calib::CameraModel camera_;
    int width_ = 0;
    int height_ = 0;
    std::vector<glm::vec3> rays_; ///< (x/z, y/z, 1) of each pixel; z = 0: the camera sees nothing
};

} // namespace autostereo::devices

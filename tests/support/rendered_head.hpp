#pragma once

#include "calib/camera_model.hpp"
#include "calib/eye_pair.hpp"
#include "tests/support/rgb_picture.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace autostereo::test {

/// Where a head is before a camera, and how it is lit and taken.
struct HeadView {
    glm::dvec3 middle{0, 0, 1}; ///< of the eyes, camera's frame, metres
    /// Turned away from facing the camera, radians: about the head's upright, its transverse axis
    /// and its sagittal one.
    double yaw = 0, pitch = 0, roll = 0;
    double gain = 1;        ///< exposure of the whole picture
    double fromTheSide = 0; ///< -1 to 1: how much more light one cheek has than the other
    double blurPx = 0.6;    ///< sigma of lens and pixel
    double noise = 3;       ///< sigma, of 255
    std::uint32_t seed = 1;
};

/// What the camera gives of it, and the truth.
struct HeadPicture {
    RgbPicture picture;
    std::vector<std::uint16_t> depthMm; ///< along the camera's axis; of the backdrop 2500
    calib::EyePair eyes; ///< the viewer's left and right pupil, camera's frame, metres
};

/// A head: a mesh of an ellipsoid with a nose and sockets, on it a portrait in the public domain
/// (tests/data/head), drawn by a plain z-buffer in double precision, nine samples a pixel.
class RenderedHead {
  public:
    RenderedHead();
    [[nodiscard]] HeadPicture draw(const calib::CameraModel& camera, const RgbPicture& backdrop,
                                   const HeadView& view) const;
    [[nodiscard]] double eyeSpacingM() const;

  private:
    struct Vertex {
        glm::dvec3 place; ///< metres from between the eyes; x, y as in the portrait, z to the back
        glm::dvec2 texel;
    };
    [[nodiscard]] glm::dvec3 surface(const glm::dvec2& texel) const;
    [[nodiscard]] glm::dvec3 colorAt(const glm::dvec2& texel) const;

    RgbPicture portrait_;
    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> triangles_; ///< three vertices each
};

} // namespace autostereo::test

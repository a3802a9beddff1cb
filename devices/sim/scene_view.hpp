#pragma once

#include "calib/camera_model.hpp"
#include "calib/rigid_transform.hpp"
#include "devices/sim/scene.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace autostereo::devices::sim {

/// The exact answer for one pixel: what its ray hits. `Hit::distance` is then the depth along the
/// camera's axis. Nothing where the camera model has no ray.
[[nodiscard]] std::optional<Hit> hitAtPixel(const Snapshot& snapshot,
                                            const calib::CameraModel& camera,
                                            const calib::RigidTransform& sceneFromCamera,
                                            const glm::dvec2& pixel);

/// A scene drawn from one camera, a ray through the centre of each pixel, the same as `hitAtPixel`
/// bit for bit. Rays and the fixed bodies' depth are kept, so that a frame costs only the screen
/// boxes of the bodies that move. The scene must outlive the view. Thread-bound.
class SceneView {
  public:
    using PixelSink = std::function<void(std::size_t pixel, const Hit&)>;

    /// `background` gets each pixel that has a ray, with what it hits of the fixed bodies.
    SceneView(const Scene& scene, const calib::CameraModel& camera,
              const calib::RigidTransform& sceneFromCamera, const PixelSink& background);

    /// Each pixel that a moving body covers at that time.
    void drawMoving(double timeSeconds, const PixelSink& sink) const;

  private:
    struct Range {
        double least = kNoHit;
        double most = -kNoHit;
        void add(double value);
        [[nodiscard]] bool meets(const Range& other) const;
    };
    struct PixelBox {
        std::size_t left, right, top, bottom; ///< right and bottom excluded
        [[nodiscard]] bool hasRow(std::size_t row) const { return top <= row && row < bottom; }
    };
    struct Candidate {
        const Body* body;
        BodyFromPoint view;
        PixelBox box;
    };
    struct RowScratch {
        std::vector<double> nearest;
        std::vector<const Body*> seen;
    };
    [[nodiscard]] PixelBox boxAround(const Body& body) const;
    /// First and last + 1 of the ranges that meet `wanted`.
    [[nodiscard]] static std::pair<std::size_t, std::size_t>
    spanOf(const std::vector<Range>& ranges, const Range& wanted);
    void draw(std::span<const Body> bodies, const std::vector<double>& behind,
              const PixelSink& sink) const;
    void drawRow(std::size_t row, std::span<const Candidate> candidates,
                 std::span<const double> behind, RowScratch& scratch, const PixelSink& sink) const;
    void makeRays(const calib::CameraModel& camera);

    const Scene& scene_;
    calib::RigidTransform sceneFromCamera_;
    std::vector<glm::dvec3> directions_; ///< scene frame, 1 along the camera's axis; 0: no ray
    std::vector<Range> columns_;         ///< x/z of the rays of each column
    std::vector<Range> rows_;            ///< y/z of the rays of each row
    std::vector<double> fixedDistances_; ///< 0 where there is no ray
};

} // namespace autostereo::devices::sim

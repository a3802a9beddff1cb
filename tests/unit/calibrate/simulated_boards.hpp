#pragma once

#include "calib/sensor_rig.hpp"
#include "calib/solve/rig_solver.hpp"

#include <glm/gtc/quaternion.hpp>

#include <random>
#include <string>
#include <vector>

namespace autostereo::calibrate {

/// Seeded rigs and what they see of a board: exact corners plus noise.
class SimulatedBoards {
  public:
    explicit SimulatedBoards(std::uint32_t seed) : engine_(seed) {}

    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    double gaussian(double sigma) {
        return sigma > 0 ? std::normal_distribution<double>(0, sigma)(engine_) : 0;
    }

    calib::CameraModel camera(int width, int height, double focalShare) {
        calib::CameraModel made;
        const double focal = focalShare * width * between(0.95, 1.05);
        made.intrinsics = {width,
                           height,
                           focal,
                           focal * between(0.995, 1.005),
                           width * between(0.48, 0.52) - 0.5,
                           height * between(0.48, 0.52) - 0.5};
        made.distortion.k1 = between(-0.25, 0.1);
        made.distortion.k2 = between(-0.05, 0.15);
        made.distortion.p1 = between(-1e-3, 1e-3);
        made.distortion.p2 = between(-1e-3, 1e-3);
        made.distortion.k3 = between(-0.1, 0.05);
        return made;
    }
    /// As an Azure Kinect's: 640x576 depth, 1280x720 colour, some centimetres apart.
    calib::SensorRig rig() {
        calib::SensorRig made{camera(640, 576, 0.79), camera(1280, 720, 0.48), {}, "simulated"};
        const glm::dvec3 turn{between(-0.05, 0.05), between(-0.03, 0.03), between(-0.02, 0.02)};
        made.colorFromDepth =
            stepped({}, turn, {between(-0.06, -0.03), between(-0.01, 0.01), between(-0.01, 0.01)});
        return made;
    }
    /// In front of the camera, tilted to any side by at most `tilt` (radians).
    calib::RigidTransform pose(const Board& board, double nearM, double farM, double tilt) {
        const double z = between(nearM, farM);
        const glm::dvec3 turn{between(-tilt, tilt), between(-tilt, tilt), between(-0.3, 0.3)};
        const glm::dvec3 middle = 0.5 * board.corner(board.corners() - 1);
        const calib::RigidTransform turned = stepped({}, turn, glm::dvec3(0));
        const glm::dvec3 centre{z * between(-0.35, 0.35), z * between(-0.22, 0.22), z};
        return {turned.rotation, centre - turned.rotation * middle};
    }

    /// Corners as a camera at `cameraFromBoard` finds them; empty where any lies outside.
    BoardView view(const calib::CameraModel& camera, const Board& board,
                   const calib::RigidTransform& cameraFromBoard, double noisePx,
                   const std::string& name) {
        BoardView seen{name, {}, {}};
        for (int id = 0; id < board.corners(); ++id) {
            const auto pixel = camera.project(cameraFromBoard * board.corner(id));
            if (!pixel || pixel->x < 2 || pixel->y < 2 || pixel->x > camera.intrinsics.width - 3 ||
                pixel->y > camera.intrinsics.height - 3)
                return {name, {}, {}};
            seen.ids.push_back(id);
            seen.pixels.push_back(*pixel + glm::dvec2{gaussian(noisePx), gaussian(noisePx)});
        }
        return seen;
    }

    /// Pairs of views that both cameras see, and the poses in the depth camera's frame.
    struct Seen {
        RigViews views;
        std::vector<calib::RigidTransform> poses;
    };
    Seen views(const calib::SensorRig& rig, const Board& board, int count, double noisePx,
               double nearM, double farM, double tilt) {
        Seen seen;
        for (int attempt = 0; attempt < 200 * count && static_cast<int>(seen.poses.size()) < count;
             ++attempt) {
            const calib::RigidTransform at = pose(board, nearM, farM, tilt);
            const std::string name = std::to_string(attempt);
            BoardView depth = view(rig.depth, board, at, noisePx, "depth " + name);
            BoardView color =
                view(rig.color, board, rig.colorFromDepth * at, noisePx, "colour " + name);
            if (depth.ids.empty() || color.ids.empty()) continue;
            seen.views.pairs.emplace_back(seen.poses.size(), seen.poses.size());
            seen.views.depth.push_back(std::move(depth));
            seen.views.color.push_back(std::move(color));
            seen.poses.push_back(at);
        }
        return seen;
    }

  private:
    std::mt19937 engine_;
};

constexpr Board kSimulatedBoard{9, 6, 0.060, {}};
constexpr PictureSizes kSimulatedSizes{640, 576, 1280, 720};

} // namespace autostereo::calibrate

#pragma once

#include "calib/depth_noise.hpp"
#include "calib/solve/board.hpp"
#include "calib/solve/pose_start.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

// A board in the depth camera's own measurements.

namespace autostereo::calibrate {

/// One depth picture, counts (0, 65535: no measurement), top row first.
struct DepthPicture {
    int width = 0;
    int height = 0;
    double unitM = 1e-3; ///< metres of a count
    std::vector<std::uint16_t> counts;
    std::vector<std::uint16_t> amplitudes; ///< as many, or none

    /// Metres along the axis between pixels: 1/z of the four around is linear on a plane. None
    /// where one is missing or they are of two surfaces.
    [[nodiscard]] std::optional<double> at(const glm::dvec2& pixel) const;
    /// Of the nearest pixel; 0 without amplitudes.
    [[nodiscard]] double amplitudeAt(const glm::dvec2& pixel) const;

  private:
    [[nodiscard]] std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

/// The depth camera's own 3-D points of the corners that both cameras see, with the colour pixels
/// (de Sorbier 2010, section II.B); trusted by their noise, the surest fully.
[[nodiscard]] std::vector<PointPixel> pointsOf(const calib::CameraModel& depthCamera,
                                               const DepthPicture& picture, const BoardView& depth,
                                               const BoardView& color,
                                               const calib::DepthNoise& noise);

/// How much too far the depth camera measures, beside where its infrared picture sees the board.
struct DepthBias {
    double atOneMetreM = 0;
    double perMetreM = 0; ///< and more per metre beyond one
    double at95M = 0;     ///< half the 95 % interval of the first, views taken for independent
    double darkM = 0;     ///< how much farther dark squares are measured than bright ones
    double nearestM = 0, farthestM = 0; ///< ranges of the views
    std::size_t views = 0;
};

struct DepthBoard {
    const BoardView* view;
    const DepthPicture* picture;
};
/// Over the middles of the squares of every view. None with fewer than three views that can be
/// measured.
[[nodiscard]] std::optional<DepthBias> depthBias(const calib::CameraModel& depthCamera,
                                                 const Board& board,
                                                 std::span<const DepthBoard> boards);

} // namespace autostereo::calibrate

#pragma once

#include "calib/solve/board.hpp"
#include "calib/solve/bundle.hpp"
#include "calib/solve/lens_model.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace autostereo::calibrate {

/// One lens model tried on the same views.
struct ModelTrial {
    LensModel lens = LensModel::Plain;
    double rmsPx = 0;
    /// Rms over views that the model was not fitted to (only their boards' poses were): a model
    /// that bends to noise, or lacks a term, is worse here though its own rms looks good.
    double heldOutPx = 0;
    double focalPx = 0; ///< fx
    double focal95Px = 0;
    double condition = 0;               ///< of the parameters' correlation
    std::vector<double> heldOutSquares; ///< mean square of each view, px^2
};

struct ViewScore {
    std::string name;
    double rmsPx = 0;
    bool rejected = false;
};

/// A camera with what is known of its numbers' worth.
struct CameraCalibration {
    calib::CameraModel camera;
    LensModel lens = LensModel::Five;
    std::vector<ModelTrial> trials;
    std::vector<ViewScore> views; ///< all that were given
    double rmsPx = 0;
    double heldOutPx = 0;
    CameraParameters half95{}; ///< of fx fy cx cy k1 k2 p1 p2 k3 k4 k5 k6: true within +- (95 %)
    double condition = 0;      ///< of the parameters' correlation
    double tiltRad = 0;        ///< largest angle between two boards
    double coverage = 0;       ///< share of the picture's cells (8 x 6) with corners
    std::vector<std::string> warnings;

    /// Names of the views that count.
    [[nodiscard]] bool isKept(const std::string& name) const;
};

/// Intrinsics and distortion from views of one board: outlier views are dropped one by one, models
/// of rising order are compared by held-out views, the covariance is that of least squares.
/// Throws Refusal where the views cannot tell: fewer than five, boards all parallel or too far, a
/// focal length not known to 5 %. Deterministic; reentrant.
[[nodiscard]] CameraCalibration
calibrateCamera(const Board& board, std::span<const BoardView> views, int width, int height);

constexpr std::size_t kFewestViews = 5;
/// 95 % of a normal distribution lie within so many standard deviations.
constexpr double kSigmas95 = 1.959964;

/// A single view's part of a bundle.
void addSightings(Bundle& bundle, const Board& board, const BoardView& view, std::size_t index,
                  std::size_t camera, double weight = 1);

/// The camera and each view's board as a bundle; views whose pose cannot be guessed throw Refusal.
[[nodiscard]] Bundle bundleOf(const calib::CameraModel& camera, LensModel lens, const Board& board,
                              std::span<const BoardView> views);

} // namespace autostereo::calibrate

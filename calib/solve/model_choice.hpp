#pragma once

#include "calib/solve/camera_solver.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace autostereo::calibrate {

/// Fits each model, the simpler one's answer being the next one's start, and asks each about the
/// views it has not seen: one at a time up to eight views, else in six parts.
[[nodiscard]] std::vector<ModelTrial> tryModels(const calib::CameraModel& start, const Board& board,
                                                std::span<const BoardView> views);

/// The model to use. Up to five terms: the richest that is not clearly worse on held-out views than
/// the best, because a term left out hides in the focal length and makes its interval a lie, while
/// one too many only widens it. The rational model bends wildly beyond the corners and its terms
/// stand for each other: only where it is clearly better (two standard errors of the paired
/// difference) and the views tell its terms apart.
[[nodiscard]] LensModel chooseModel(std::span<const ModelTrial> trials);

/// What people should know of the models that were not taken, a line each: a simpler one with a
/// good rms and a focal length that is off, a richer one that predicts better but is not supported.
[[nodiscard]] std::vector<std::string> warningsOf(std::span<const ModelTrial> trials,
                                                  LensModel chosen);

} // namespace autostereo::calibrate

#pragma once

#include "calib/solve/symmetric_matrix.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace autostereo::calibrate {

/// Derivative of a residual by one free parameter.
struct Slope {
    std::size_t parameter;
    double value;
};

/// J^T W J and J^T W r, gathered residual by residual.
struct NormalEquations {
    explicit NormalEquations(std::size_t parameters) : matrix(parameters), right(parameters) {}

    SymmetricMatrix matrix;
    std::vector<double> right;
    double cost = 0; ///< sum of weighted squares
    std::size_t residuals = 0;

    /// `residual` = measured - modelled; the slopes are of the model, their parameters rising.
    /// Fills the lower triangle: `complete` comes last.
    void add(std::span<const Slope> slopes, double residual, double weight) {
        cost += weight * residual * residual;
        ++residuals;
        for (std::size_t i = 0; i < slopes.size(); ++i) {
            const double scaled = weight * slopes[i].value;
            right[slopes[i].parameter] += scaled * residual;
            for (std::size_t j = 0; j <= i; ++j)
                matrix.at(slopes[i].parameter, slopes[j].parameter) += scaled * slopes[j].value;
        }
    }
    void complete() { matrix.mirror(); }
};

struct LeastSquaresFit {
    double cost = 0; ///< sum of weighted squares at the end
    std::size_t residuals = 0;
    int steps = 0;
    bool converged = false;
    std::optional<SymmetricMatrix> inverse; ///< of J^T W J; none: some parameter cannot be told

    /// Residuals minus parameters.
    [[nodiscard]] double freedom() const {
        const std::size_t parameters = inverse ? inverse->size() : 0;
        return residuals > parameters ? static_cast<double>(residuals - parameters) : 0;
    }
};

/// Levenberg and Marquardt's method: at most 60 steps. `linearise(state, equations)` fills the
/// equations (false: the state is impossible), `moved(state, step)` is the state a step away.
template<class State, class Linearise, class Moved>
LeastSquaresFit minimise(State& state, std::size_t parameters, const Linearise& linearise,
                         const Moved& moved) {
    constexpr int kMostSteps = 60, kMostTries = 12;
    constexpr double kLeastGain = 1e-10; // of the cost
    LeastSquaresFit fit;
    NormalEquations now(parameters);
    if (!linearise(state, now)) return fit;
    now.complete();
    double damping = 1e-4;
    for (; fit.steps < kMostSteps && !fit.converged; ++fit.steps) {
        const double before = now.cost;
        bool better = false;
        for (int attempt = 0; attempt < kMostTries && !better; ++attempt) {
            const auto step = now.matrix.solved(now.right, damping);
            if (step) {
                State next = moved(state, *step);
                NormalEquations there(parameters);
                better = linearise(next, there) && there.cost <= now.cost;
                if (better) {
                    there.complete();
                    state = std::move(next);
                    now = std::move(there);
                }
            }
            damping = better ? std::fmax(damping * 0.1, 1e-12) : damping * 10;
        }
        // No step helps: the bottom, as far as rounding lets it be found.
        fit.converged = !better || before - now.cost <= kLeastGain * before;
    }
    fit.cost = now.cost;
    fit.residuals = now.residuals;
    fit.inverse = now.matrix.inverse();
    return fit;
}

} // namespace autostereo::calibrate

#include "devices/sim/calibration_board.hpp"

#include "devices/sim/placement.hpp"

#include <cmath>

namespace autostereo::devices::sim {

calib::RigidTransform boardPose(double timeSeconds) {
    const auto wave = [&](int turns, double phase) {
        constexpr double kTwoPi = 6.283185307179586;
        return std::sin(kTwoPi * (turns * timeSeconds / kBoardPeriodS + phase));
    };
    const glm::dmat3 rotation = turn(0.45 * wave(2, 0.0), {0, 1, 0}) *
                                turn(0.38 * wave(3, 0.2), {1, 0, 0}) *
                                turn(0.25 * wave(1, 0.1), {0, 0, 1});
    return {rotation, {0.20 * wave(3, 0.4), 0.08 * wave(2, 0.15), 1.20 + 0.22 * wave(1, 0.3)}};
}

Body boardAt(double timeSeconds) {
    constexpr double kMarginM = 0.040;
    return {Shape::Box,
            boardPose(timeSeconds),
            {0.5 * kBoardColumns * kBoardSquareM + kMarginM,
             0.5 * kBoardRows * kBoardSquareM + kMarginM, kBoardHalfThicknessM},
            {chessboard, {240, 240, 236}, 0.80, 0, 0}};
}

} // namespace autostereo::devices::sim

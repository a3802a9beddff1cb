#include "calib/solve/camera_solver.hpp"
#include "calib/solve/refusal.hpp"
#include "calib/solve/time_offset.hpp"
#include "config/load.hpp"
#include "config/units.hpp"
#include "daemon/commands/calibration_boards.hpp"
#include "daemon/commands/commands.hpp"
#include "daemon/commands/rig_quality.hpp"
#include "daemon/log.hpp"

namespace autostereo::daemon {

namespace {

using calibrate::TimedPlace;

/// Where the board's middle was in each view, in the depth camera's frame.
std::vector<TimedPlace> track(const calib::CameraModel& camera,
                              const calib::RigidTransform& depthFromCamera,
                              const calibrate::Board& board,
                              const std::vector<calibrate::BoardView>& views,
                              const std::vector<double>& timesS) {
    const glm::dvec3 middle = 0.5 * board.corner(board.corners() - 1);
    std::vector<TimedPlace> places;
    for (std::size_t i = 0; i < views.size(); ++i)
        if (const auto pose = calibrate::startingPose(camera, board, views[i]))
            if (places.empty() || timesS[i] > places.back().timeS)
                places.push_back({timesS[i], depthFromCamera * (*pose * middle)});
    return places;
}

} // namespace

int calibrateTiming(const BoardOptions& options) {
    requireRigFile(options);
    setUpLog("warn");
    if (!options.input)
        throw UsageError("calibrate timing: needs --input: single pictures have no time");
    config::RigFile file = config::readRigFile(*options.rig);
    const calib::SensorRig rig = config::loadRig(*options.rig);
    const calibrate::Board board = boardOf(options);
    const FoundBoards found = findBoards(options);
    requireSizesOf(rig, found.sizes);
    const auto depth = track(rig.depth, {}, board, found.views.depth, found.depthTimesS);
    const auto color =
        track(rig.color, rig.colorFromDepth.inverse(), board, found.views.color, found.colorTimesS);
    try {
        const calibrate::TimeOffset offset = calibrate::timeOffset(depth, color);
        file.colorLateS = offset.colorLateS;
        file.quality["color_late_95_ms"] = config::units::msFromSeconds(offset.late95S);
    } catch (const calibrate::Refusal& refusal) {
        throw calibrate::Refusal(std::string("calibrate timing: ") + refusal.what());
    }
    deliver(file, options);
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon

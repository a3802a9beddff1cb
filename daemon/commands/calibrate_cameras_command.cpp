#include "calib/solve/refusal.hpp"
#include "daemon/commands/calibrate_points.hpp"
#include "daemon/commands/calibration_boards.hpp"
#include "daemon/commands/commands.hpp"
#include "daemon/commands/rig_quality.hpp"
#include "daemon/log.hpp"

#include <cstdio>
#include <iostream>

namespace autostereo::daemon {

namespace {

std::string provenanceOf(const BoardOptions& options) {
    const std::string board =
        options.board + (options.dictionary ? " ChArUco board" : " chessboard");
    std::array<char, 48> square{};
    std::snprintf(square.data(), square.size(), " of %g mm", options.squareMm);
    return "measured by autostereo calibrate from a " + board + square.data() + " in " +
           (options.input
                ? *options.input
                : std::to_string(options.depth.size() + options.color.size()) + " pictures");
}

void tellMissing(const FoundBoards& found, const BoardOptions& options) {
    if (options.json) return;
    for (const std::string& name : found.withoutBoard)
        std::cout << name << ": no board\n";
    std::cout << std::flush;
}

} // namespace

int calibrateCameras(const BoardOptions& options) {
    requireRigFile(options);
    setUpLog("warn");
    const calibrate::Board board = boardOf(options);
    const FoundBoards found = findBoards(options);
    tellMissing(found, options);
    config::RigFile file;
    file.provenance = provenanceOf(options);
    const auto one = [&](const char* prefix, const char* which,
                         const std::vector<calibrate::BoardView>& views, int width, int height) {
        if (width == 0) return;
        try {
            const auto camera = calibrate::calibrateCamera(board, views, width, height);
            if (!options.json) printCamera(which, camera);
            addCamera(file, prefix, camera);
        } catch (const calibrate::Refusal& refusal) {
            throw calibrate::Refusal(std::string("calibrate cameras: ") + which + ": " +
                                     refusal.what());
        }
    };
    const calibrate::PictureSizes& sizes = found.sizes;
    one("depth", "depth camera", found.views.depth, sizes.depthWidth, sizes.depthHeight);
    one("color", "colour camera", found.views.color, sizes.colorWidth, sizes.colorHeight);
    deliver(file, options);
    return EXIT_SUCCESS;
}

int calibrateRig(const BoardOptions& options) {
    requireRigFile(options);
    setUpLog("warn");
    if (options.pairs || options.rig) return calibrateFromPoints(options);
    const calibrate::Board board = boardOf(options);
    const FoundBoards found = findBoards(options);
    tellMissing(found, options);
    config::RigFile file;
    file.provenance = provenanceOf(options);
    try {
        const auto rig = calibrate::calibrateRig(board, found.views, found.sizes);
        if (!options.json) {
            printCamera("depth camera", rig.depth);
            printCamera("colour camera", rig.color);
        }
        addRig(file, rig);
        addDepthBias(file, found, board);
    } catch (const calibrate::Refusal& refusal) {
        throw calibrate::Refusal(std::string("calibrate rig: ") + refusal.what());
    }
    deliver(file, options);
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon

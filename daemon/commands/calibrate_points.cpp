#include "daemon/commands/calibrate_points.hpp"

#include "calib/solve/pose_solver.hpp"
#include "calib/solve/refusal.hpp"
#include "config/load.hpp"
#include "config/text_file.hpp"
#include "config/units.hpp"
#include "daemon/commands/calibration_boards.hpp"
#include "daemon/commands/rig_quality.hpp"
#include "devices/input.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace autostereo::daemon {

namespace {

/// One pair a line: depth pixel x y, its depth in mm, colour pixel x y; # begins a comment.
std::vector<calibrate::PointPixel> readPairs(const std::filesystem::path& file,
                                             const calib::CameraModel& depth) {
    std::istringstream text(config::readTextFile(file));
    std::vector<calibrate::PointPixel> pairs;
    int number = 0;
    for (std::string line; std::getline(text, line);) {
        ++number;
        line.resize(std::min(line.find('#'), line.size()));
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        std::istringstream fields(line);
        double x = 0, y = 0, mm = 0;
        calibrate::PointPixel pair;
        std::string rest;
        const auto wrong = [&](const std::string& what) {
            throw config::ConfigError(file.string() + ":" + std::to_string(number) + ": " + what);
        };
        if (!(fields >> x >> y >> mm >> pair.pixel.x >> pair.pixel.y) || fields >> rest)
            wrong("is no pair (needs depth x, y, depth in mm, colour x, y)");
        if (!(mm > 0)) wrong("depth is " + std::to_string(mm) + " (allowed > 0 mm)");
        const auto ray = depth.unproject({x, y});
        if (!ray) wrong("the depth camera has no ray for that pixel");
        const double z = config::units::metresFromMm(mm);
        pair.point = {z * ray->x, z * ray->y, z};
        pairs.push_back(pair);
    }
    return pairs;
}

struct Points {
    std::vector<calibrate::PointPixel> pairs;
    std::string source; ///< for the file's provenance
    double tolerancePx; ///< of an honest colour pixel
};

Points listedPoints(const BoardOptions& options, const calib::SensorRig& known) {
    constexpr double kClickPx = 8;
    return {readPairs(*options.pairs, known.depth), "listed point pairs", kClickPx};
}

/// Corners of a board, with the depth that was measured there.
Points measuredPoints(const BoardOptions& options, const calib::SensorRig& known) {
    constexpr double kCornerPx = 3;
    if (!options.input)
        throw UsageError("calibrate rig: --rig needs --pairs or --input, whose depth is measured");
    const FoundBoards found = findBoards(options);
    requireSizesOf(known, found.sizes);
    Points points{{}, "points that the depth camera measured", kCornerPx};
    for (const auto& [d, c] : found.views.pairs)
        std::ranges::copy(calibrate::pointsOf(known.depth, found.depthPictures[d],
                                              found.views.depth[d], found.views.color[c], {}),
                          std::back_inserter(points.pairs));
    return points;
}

} // namespace

int calibrateFromPoints(const BoardOptions& options) try {
    if (!options.rig) throw UsageError("--pairs: needs the cameras' own numbers (--rig)");
    const calib::SensorRig known = config::loadRig(*options.rig);
    const Points points =
        options.pairs ? listedPoints(options, known) : measuredPoints(options, known);
    const calibrate::PoseFit fit =
        calibrate::solvePose(known.color, points.pairs, points.tolerancePx);
    config::RigFile file;
    file.depth = known.depth;
    file.color = known.color;
    file.colorFromDepth = fit.cameraFromPoints;
    file.colorLateS = known.colorLateS;
    file.provenance = "transform from " + std::to_string(fit.inliers.size()) + ' ' + points.source +
                      " by autostereo calibrate; cameras: " + known.provenance;
    const auto half95 = [&](std::size_t first) {
        double most = 0;
        for (std::size_t i = first; i < first + 3; ++i)
            most = std::fmax(most, fit.covariance.at(i, i));
        return calibrate::kSigmas95 * std::sqrt(most);
    };
    file.quality["points"] = static_cast<double>(fit.inliers.size());
    file.quality["rms_px"] = fit.rmsPx;
    file.quality["rotation_95_deg"] = config::units::degFromRadians(half95(0));
    file.quality["translation_95_mm"] = config::units::mmFromMetres(half95(3));
    const std::size_t rejected = points.pairs.size() - fit.inliers.size();
    if (options.pairs) {
        for (std::size_t i = 0; i < points.pairs.size(); ++i)
            if (std::ranges::count(fit.inliers, i) == 0)
                file.warnings.push_back("pair " + std::to_string(i + 1) + " rejected");
    } else if (rejected > 0) {
        file.warnings.push_back(std::to_string(rejected) + " of " +
                                std::to_string(points.pairs.size()) + " points rejected");
    }
    deliver(file, options);
    return EXIT_SUCCESS;
} catch (const calibrate::Refusal& refusal) {
    throw calibrate::Refusal(std::string("calibrate rig: ") + refusal.what());
}

} // namespace autostereo::daemon

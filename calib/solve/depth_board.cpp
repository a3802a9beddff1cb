#include "calib/solve/depth_board.hpp"

#include "calib/solve/camera_solver.hpp"
#include "calib/solve/least_squares.hpp"
#include "calib/solve/pose_solver.hpp"
#include "calib/solve/refusal.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace autostereo::calibrate {

namespace {

/// Where the board stands before the depth camera.
std::optional<calib::RigidTransform> poseOf(const calib::CameraModel& camera, const Board& board,
                                            const BoardView& view) try {
    constexpr double kTolerancePx = 2;
    const auto start = startingPose(camera, board, view);
    if (!start) return std::nullopt;
    std::vector<PointPixel> pairs;
    for (std::size_t i = 0; i < view.size(); ++i)
        pairs.push_back({board.corner(view.ids[i]), view.pixels[i]});
    return settlePose(camera, pairs, kTolerancePx, *start).cameraFromPoints;
} catch (const Refusal&) {
    return std::nullopt; // too few corners agree: the bias is told from other views
}

double mean(const std::vector<double>& numbers) {
    double sum = 0;
    for (const double number : numbers)
        sum += number;
    return sum / static_cast<double>(numbers.size());
}

/// Of one view: how much too far its squares are measured.
struct ViewBias {
    double rangeM, biasM;
    double darkM; ///< dark squares' minus bright ones'
};

std::optional<ViewBias> biasOf(const calib::CameraModel& camera, const Board& board,
                               const DepthBoard& seen) {
    const auto pose = poseOf(camera, board, *seen.view);
    if (!pose) return std::nullopt;
    std::array<std::vector<double>, 2> off, amplitudes; // by the squares' colour
    std::vector<double> ranges;
    for (int row = 0; row + 1 < board.rows; ++row)
        for (int column = 0; column + 1 < board.columns; ++column) {
            const glm::dvec3 middle{(column + 0.5) * board.squareM, (row + 0.5) * board.squareM, 0};
            const glm::dvec3 point = *pose * middle;
            const auto pixel = camera.project(point);
            const auto z = pixel ? seen.picture->at(*pixel) : std::nullopt;
            if (!z) continue;
            const auto colour = static_cast<std::size_t>((row + column) % 2);
            off.at(colour).push_back(*z - point.z);
            amplitudes.at(colour).push_back(seen.picture->amplitudeAt(*pixel));
            ranges.push_back(point.z);
        }
    constexpr std::size_t kFewest = 4;
    if (off[0].size() < kFewest || off[1].size() < kFewest) return std::nullopt;
    const double first = mean(off[0]), second = mean(off[1]);
    const bool firstIsDark = mean(amplitudes[0]) < mean(amplitudes[1]);
    return ViewBias{mean(ranges), (first + second) / 2,
                    firstIsDark ? first - second : second - first};
}

} // namespace

std::optional<double> DepthPicture::at(const glm::dvec2& pixel) const {
    constexpr double kOneSurface = 0.02; // of the range, over one pixel
    const int x = static_cast<int>(std::floor(pixel.x)), y = static_cast<int>(std::floor(pixel.y));
    if (x < 0 || y < 0 || x + 1 >= width || y + 1 >= height) return std::nullopt;
    const double u = pixel.x - x, v = pixel.y - y;
    double inverse = 0;
    std::uint16_t nearest = 65535, farthest = 0;
    for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
        const std::uint16_t count = counts[place(x + dx, y + dy)];
        if (count == 0 || count == 65535) return std::nullopt;
        nearest = std::min(nearest, count);
        farthest = std::max(farthest, count);
        inverse += (dx == 1 ? u : 1 - u) * (dy == 1 ? v : 1 - v) / count;
    }
    if (farthest - nearest > kOneSurface * nearest) return std::nullopt;
    return unitM / inverse;
}

double DepthPicture::amplitudeAt(const glm::dvec2& pixel) const {
    const auto x = std::clamp(static_cast<int>(std::lround(pixel.x)), 0, width - 1);
    const auto y = std::clamp(static_cast<int>(std::lround(pixel.y)), 0, height - 1);
    return amplitudes.empty() ? 0 : amplitudes[place(x, y)];
}

std::vector<PointPixel> pointsOf(const calib::CameraModel& depthCamera, const DepthPicture& picture,
                                 const BoardView& depth, const BoardView& color,
                                 const calib::DepthNoise& noise) {
    std::vector<PointPixel> pairs;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        const auto there = std::ranges::find(color.ids, depth.ids[i]);
        if (there == color.ids.end()) continue;
        const auto z = picture.at(depth.pixels[i]);
        const auto ray = depthCamera.unproject(depth.pixels[i]);
        if (!z || !ray) continue;
        const double trust = noise.floorM / noise.sigmaAtRangeM(*z);
        pairs.push_back({*z * glm::dvec3(*ray, 1),
                         color.pixels[static_cast<std::size_t>(there - color.ids.begin())],
                         trust * trust});
    }
    return pairs;
}

std::optional<DepthBias> depthBias(const calib::CameraModel& depthCamera, const Board& board,
                                   std::span<const DepthBoard> boards) {
    constexpr std::size_t kFewestBoards = 3;
    std::vector<ViewBias> views;
    for (const DepthBoard& seen : boards)
        if (const auto bias = biasOf(depthCamera, board, seen)) views.push_back(*bias);
    if (views.size() < kFewestBoards) return std::nullopt;
    NormalEquations line(2);
    DepthBias found{.nearestM = views[0].rangeM, .farthestM = views[0].rangeM};
    for (const ViewBias& view : views) {
        line.add(std::array{Slope{0, 1.0}, Slope{1, view.rangeM - 1}}, view.biasM, 1);
        found.nearestM = std::fmin(found.nearestM, view.rangeM);
        found.farthestM = std::fmax(found.farthestM, view.rangeM);
        found.darkM += view.darkM / static_cast<double>(views.size());
    }
    line.complete();
    const auto inverse = line.matrix.inverse();
    const auto answer = line.matrix.solved(line.right, 0);
    if (!inverse || !answer) return std::nullopt; // all at one range
    found.atOneMetreM = answer->at(0);
    found.perMetreM = answer->at(1);
    found.views = views.size();
    double squares = 0;
    for (const ViewBias& view : views)
        squares +=
            std::pow(view.biasM - found.atOneMetreM - found.perMetreM * (view.rangeM - 1), 2);
    found.at95M =
        kSigmas95 * std::sqrt(inverse->at(0, 0) * squares /
                              static_cast<double>(std::max<std::size_t>(views.size() - 2, 1)));
    return found;
}

} // namespace autostereo::calibrate

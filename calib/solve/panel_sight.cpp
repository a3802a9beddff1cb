#include "calib/solve/panel_sight.hpp"

#include "calib/solve/board_detector.hpp"
#include "calib/solve/pose_solver.hpp"
#include "calib/solve/refusal.hpp"
#include "calib/srgb.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autostereo::calibrate {

namespace {

constexpr double kCornerTolerancePx = 1.5;
constexpr int kCells = 256;             // each way: waves of up to 128 cycles
constexpr double kLeastContrast = 0.05; // an eighth of what the narrowest slits leave

std::vector<std::uint16_t> greyOf(const ColorImage& image) {
    std::vector<std::uint16_t> grey;
    grey.reserve(image.rgb.size() / 3);
    for (std::size_t at = 0; at + 2 < image.rgb.size(); at += 3)
        grey.push_back(static_cast<std::uint16_t>(
            (image.rgb[at] + 2 * image.rgb[at + 1] + image.rgb[at + 2]) / 4));
    return grey;
}

/// The board's corners in the picture, the upper left one first.
BoardView cornersIn(const calib::PanelBoard& board, const Board& plain,
                    const PanelPhotographs& shots) {
    const auto grey = greyOf(shots.board);
    auto view = findBoard({shots.board.width, shots.board.height, grey, false}, plain, shots.name);
    if (!view || view->pixels.size() != board.cornersM.size())
        throw Refusal(shots.name + ": the chessboard is not seen wholly (show pattern "
                                   "calibration-board, the whole panel in the picture)");
    auto& pixels = view->pixels;
    if (pixels.front().y > pixels.back().y) std::ranges::reverse(pixels); // upright
    return std::move(*view);
}

/// Display space -> camera.
PoseFit poseOf(const calib::PanelBoard& board, const calib::CameraModel& camera,
               const PanelPhotographs& shots) {
    const double square = board.cornersM[1].x - board.cornersM[0].x;
    const Board plain{board.columns, board.rows, square, {}};
    const BoardView view = cornersIn(board, plain, shots);
    const auto start = startingPose(camera, plain, view);
    if (!start) throw Refusal(shots.name + ": the chessboard's corners make no plane");
    // A board's y runs down and its z away from who looks at it.
    const glm::dmat3 turned(glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1));
    const calib::RigidTransform displayFromBoard{turned, {board.cornersM.front(), 0.0}};
    std::vector<PointPixel> pairs;
    for (std::size_t i = 0; i < view.size(); ++i)
        pairs.push_back({{board.cornersM[i], 0.0}, view.pixels[i]});
    return settlePose(camera, pairs, kCornerTolerancePx, *start * displayFromBoard.inverse());
}

/// Where on the panel a camera's pixels look.
class PanelRays {
  public:
    PanelRays(const calib::CameraModel& camera, const calib::RigidTransform& cameraFromDisplay)
        : camera_(camera), displayFromCamera_(cameraFromDisplay.inverse()) {}

    [[nodiscard]] std::optional<glm::dvec2> point(double x, double y) const {
        const auto ray = camera_.unproject({x, y});
        if (!ray) return std::nullopt;
        const glm::dvec3 direction = displayFromCamera_.rotation * glm::dvec3(*ray, 1.0);
        const glm::dvec3& eye = displayFromCamera_.translation;
        if (direction.z >= 0) return std::nullopt; // away from the panel
        return glm::dvec2(eye - direction * (eye.z / direction.z));
    }
    [[nodiscard]] const glm::dvec3& eye() const { return displayFromCamera_.translation; }

  private:
    const calib::CameraModel& camera_;
    calib::RigidTransform displayFromCamera_;
};

/// The fringes of one pixel, all its colours together: amplitude and phase.
std::complex<double> fringesAt(const PanelPhotographs& shots, const calib::Srgb& srgb,
                               std::size_t at) {
    constexpr int kSteps = calib::Fringes::kSteps;
    std::complex<double> wave{0};
    double light = 0;
    for (int step = 0; step < kSteps; ++step) {
        const auto& rgb = shots.fringes.at(static_cast<std::size_t>(step)).rgb;
        const double seen = srgb.light(rgb[at]) + srgb.light(rgb[at + 1]) + srgb.light(rgb[at + 2]);
        wave += std::polar(seen, -2 * std::numbers::pi * step / kSteps);
        light += seen;
    }
    return light > 0 ? 2.0 * wave / light : 0.0;
}

WaveCells cellsOf(const calib::SubpixelLayout& panel, const PanelRays& rays,
                  const PanelPhotographs& shots) {
    const calib::Srgb srgb;
    const glm::dvec2 panelM = panel.pixelM * glm::dvec2(panel.width, panel.height);
    WaveCells cells{kCells, kCells, {}};
    cells.values.resize(static_cast<std::size_t>(kCells) * kCells);
    std::vector<int> pixels(cells.values.size());
    for (int y = 0; y < shots.board.height; ++y)
        for (int x = 0; x < shots.board.width; ++x) {
            const auto point = rays.point(x, y);
            if (!point) continue;
            const glm::dvec2 place = (*point / panelM + 0.5) * static_cast<double>(kCells);
            if (!(place.x >= 0 && place.x < kCells && place.y > 0 && place.y <= kCells)) continue;
            const auto cell = static_cast<std::size_t>(kCells - place.y) * kCells +
                              static_cast<std::size_t>(place.x);
            cells.values[cell] += fringesAt(
                shots, srgb,
                3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(shots.board.width) +
                     static_cast<std::size_t>(x)));
            ++pixels[cell];
        }
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (pixels[i] > 0) cells.values[i] /= pixels[i];
    return cells;
}

/// Of the camera's centre -R^T t, from those of R (a rotation vector on its left) and t.
glm::dmat3 eyeCovariance(const PoseFit& pose) {
    const glm::dmat3 back = glm::transpose(pose.cameraFromPoints.rotation);
    const glm::dvec3& t = pose.cameraFromPoints.translation;
    const glm::dmat3 crossT(glm::dvec3(0, t.z, -t.y), glm::dvec3(-t.z, 0, t.x),
                            glm::dvec3(t.y, -t.x, 0));
    const std::array<glm::dmat3, 2> slopes{-back * crossT, -back};
    glm::dmat3 covariance(0);
    for (std::size_t a = 0; a < 2; ++a)
        for (std::size_t b = 0; b < 2; ++b) {
            glm::dmat3 part(0);
            for (std::size_t row = 0; row < 3; ++row)
                for (std::size_t column = 0; column < 3; ++column)
                    part[static_cast<glm::length_t>(column)][static_cast<glm::length_t>(row)] =
                        pose.covariance.at(3 * a + row, 3 * b + column);
            covariance += slopes.at(a) * part * glm::transpose(slopes.at(b));
        }
    return covariance;
}

void checkSizes(const calib::CameraModel& camera, const PanelPhotographs& shots) {
    const auto check = [&](const ColorImage& image) {
        const auto [width, height] = std::pair(camera.intrinsics.width, camera.intrinsics.height);
        if (image.width != width || image.height != height ||
            image.rgb.size() !=
                3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
            throw Refusal(shots.name + ": the picture is " + std::to_string(image.width) + 'x' +
                          std::to_string(image.height) + ", its camera " + std::to_string(width) +
                          'x' + std::to_string(height));
    };
    check(shots.board);
    std::ranges::for_each(shots.fringes, check);
}

} // namespace

PanelSight seePanel(const calib::SubpixelLayout& panel, const calib::CameraModel& camera,
                    const PanelPhotographs& photographs) {
    checkSizes(camera, photographs);
    const PoseFit pose = poseOf(calib::PanelBoard(panel), camera, photographs);
    const PanelRays rays(camera, pose.cameraFromPoints);
    auto wave = fitPlaneWave(cellsOf(panel, rays, photographs), kLeastContrast);
    if (!wave)
        throw Refusal(photographs.name + ": no regular fringes are seen: the display named is "
                                         "another model than the one photographed, or something "
                                         "moved between the pictures");
    return {photographs.name, rays.eye(), eyeCovariance(pose), pose.rmsPx, std::move(*wave)};
}

} // namespace autostereo::calibrate

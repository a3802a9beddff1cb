// ChArUco boards: OpenCV's own drawing of one, seen by simulated cameras that it only partly fits.

#include "calib/solve/board_detector.hpp"
#include "calib/solve/camera_solver.hpp"
#include "tests/support/data.hpp"
#include "tests/unit/calibrate/simulated_boards.hpp"

#include <gtest/gtest.h>
#include <opencv2/aruco/charuco.hpp>

#include <algorithm>
#include <cmath>

namespace autostereo::calibrate {
namespace {

constexpr int kSquarePx = 100;

/// x/z, y/z inside each pixel, linear between its corners: exact to 1e-6 pixels here.
class PixelRays {
  public:
    explicit PixelRays(const calib::CameraModel& camera)
        : width_(camera.intrinsics.width), height_(camera.intrinsics.height) {
        for (int y = 0; y <= height_; ++y)
            for (int x = 0; x <= width_; ++x)
                corners_.push_back(camera.unproject({x - 0.5, y - 0.5}).value());
    }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] glm::dvec2 at(int pixel, double across, double down) const {
        const auto row = static_cast<std::size_t>(width_) + 1;
        const auto corner = static_cast<std::size_t>(pixel / width_) * row +
                            static_cast<std::size_t>(pixel % width_);
        return glm::mix(glm::mix(corners_[corner], corners_[corner + 1], across),
                        glm::mix(corners_[corner + row], corners_[corner + row + 1], across), down);
    }

  private:
    int width_, height_;
    std::vector<glm::dvec2> corners_;
};

/// The printed sheet: white around the squares, as on paper.
class Sheet {
  public:
    explicit Sheet(const Board& board) : board_(board) {
        const auto squares = cv::aruco::CharucoBoard::create(
            board.columns + 1, board.rows + 1, 1.0F, static_cast<float>(board.markers->share),
            cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50));
        squares->draw({kSquarePx * (board.columns + 1), kSquarePx * (board.rows + 1)}, drawing_);
    }

    /// Brightness at a place of the board's frame, metres.
    [[nodiscard]] double at(glm::dvec2 place) const {
        const glm::dvec2 px = (place / board_.squareM + 1.0) * double{kSquarePx};
        if (px.x < 0 || px.y < 0 || px.x >= drawing_.cols || px.y >= drawing_.rows) return 235;
        return drawing_.at<std::uint8_t>(static_cast<int>(px.y), static_cast<int>(px.x)) > 127 ? 235
                                                                                               : 20;
    }

    /// What a camera sees of it, a box of 4 x 4 rays a pixel.
    [[nodiscard]] std::vector<std::uint16_t> seenBy(const PixelRays& rays,
                                                    const calib::RigidTransform& cameraFromBoard,
                                                    SimulatedBoards& random) const {
        const glm::dmat3 boardFromCamera = glm::transpose(cameraFromBoard.rotation);
        const glm::dvec3 eye = -(boardFromCamera * cameraFromBoard.translation);
        std::vector<std::uint16_t> picture;
        for (int pixel = 0; pixel < rays.width() * rays.height(); ++pixel) {
            double sum = 0;
            for (int i = 0; i < 16; ++i) {
                const int down = i / 4;
                const glm::dvec3 along =
                    boardFromCamera *
                    glm::dvec3(rays.at(pixel, (i % 4 + 0.5) / 4, (down + 0.5) / 4), 1);
                const glm::dvec3 place = eye - eye.z / along.z * along;
                sum += at({place.x, place.y}) / 16;
            }
            picture.push_back(
                static_cast<std::uint16_t>(std::clamp(sum + random.gaussian(2), 0.0, 255.0)));
        }
        return picture;
    }

  private:
    Board board_;
    cv::Mat drawing_;
};

/// Where each corner of the drawing is in the board's frame, in squares: its ids may run either
/// way.
std::vector<glm::dvec2> placesOnSheet(const Board& board, const BoardView& flat) {
    std::vector<glm::dvec2> places(static_cast<std::size_t>(board.corners()));
    for (std::size_t i = 0; i < flat.size(); ++i)
        places.at(static_cast<std::size_t>(flat.ids[i])) =
            glm::round((flat.pixels[i] + 0.5) / double{kSquarePx}) - 1.0;
    return places;
}

TEST(Charuco, CornersOfPartlySeenBoardsMakeACamera) {
    const Board board{8, 6, 0.04, Markers{}};
    const Sheet sheet(board);
    SimulatedBoards random(11);
    // Seen face on, a square 100 pixels: numbers the corners.
    calib::CameraModel straight;
    straight.intrinsics = {900, 700, 100, 100, 449.5, 349.5};
    const calib::RigidTransform faceOn{glm::dmat3(1), {-3.5 * 0.04, -2.5 * 0.04, 0.04}};
    const auto flatPicture = sheet.seenBy(PixelRays(straight), faceOn, random);
    const auto flat = findBoard({900, 700, flatPicture}, board, "flat");
    ASSERT_TRUE(flat);
    ASSERT_EQ(static_cast<int>(flat->size()), board.corners());
    const auto places = placesOnSheet(board, *flat);

    calib::CameraModel camera;
    camera.intrinsics = {640, 480, 560, 562, 322, 236};
    camera.distortion.k1 = -0.12;
    camera.distortion.k2 = 0.05;
    const PixelRays rays(camera);
    std::vector<BoardView> views;
    double worst = 0, squares = 0;
    std::size_t corners = 0, partly = 0;
    for (int i = 0; i < 16; ++i) {
        const calib::RigidTransform pose = random.pose(board, 0.3, 0.5, 0.5);
        const auto picture = sheet.seenBy(rays, pose, random);
        const auto found = findBoard({640, 480, picture}, board, "view " + std::to_string(i));
        if (!found) continue;
        partly += static_cast<int>(found->size()) < board.corners() ? 1U : 0U;
        for (std::size_t c = 0; c < found->size(); ++c) {
            const glm::dvec2 place =
                board.squareM * places.at(static_cast<std::size_t>(found->ids[c]));
            const auto truth = camera.project(pose * glm::dvec3(place, 0));
            ASSERT_TRUE(truth);
            const double off = glm::length(found->pixels[c] - *truth);
            worst = std::max(worst, off);
            squares += off * off;
            ++corners;
        }
        views.push_back(*found);
    }
    const double rms = std::sqrt(squares / static_cast<double>(corners));
    std::printf("%zu views, %zu partly seen, %zu corners: rms %.3f px, worst %.2f\n", views.size(),
                partly, corners, rms, worst);
    EXPECT_GE(views.size(), 12U);
    EXPECT_GE(partly, 3U);
    EXPECT_LT(rms, 0.1) << "a tenth of a pixel is what the detector promises";

    const CameraCalibration solved = calibrateCamera(board, views, 640, 480);
    std::printf("fx %.2f +- %.2f, fy %.2f +- %.2f, cx %.2f +- %.2f, rms %.3f\n",
                solved.camera.intrinsics.fx, solved.half95[0], solved.camera.intrinsics.fy,
                solved.half95[1], solved.camera.intrinsics.cx, solved.half95[2], solved.rmsPx);
    EXPECT_NEAR(solved.camera.intrinsics.fx, 560, 2 * solved.half95[0]);
    EXPECT_NEAR(solved.camera.intrinsics.fy, 562, 2 * solved.half95[1]);
    EXPECT_NEAR(solved.camera.intrinsics.cx, 322, 2 * solved.half95[2]);
    EXPECT_NEAR(solved.camera.intrinsics.fx, 560, 2.8) << "half a percent";
}

} // namespace
} // namespace autostereo::calibrate

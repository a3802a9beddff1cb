#include "calib/solve/charuco_detector.hpp"

#include "calib/solve/refusal.hpp"

#ifdef AUTOSTEREO_ARUCO
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#endif

namespace autostereo::calibrate {

#ifdef AUTOSTEREO_ARUCO

namespace {

/// OpenCV numbers its dictionaries 4x4_50, 4x4_100, 4x4_250, 4x4_1000, 5x5_50 ...
cv::Ptr<cv::aruco::Dictionary> dictionaryOf(const Markers& markers) {
    const int size = markers.count >= 1000  ? 3
                     : markers.count >= 250 ? 2
                     : markers.count >= 100 ? 1
                                            : 0;
    return cv::aruco::getPredefinedDictionary(4 * (markers.bits - 4) + size);
}

/// OpenCV 4.6 gives corners half a pixel to the right and below of where it found them (0.49 px,
/// where the same search gives 0.00). The search again, in a window that no marker reaches into.
void refine(const cv::Mat& grey, const std::vector<std::vector<cv::Point2f>>& markers,
            cv::Point2f& corner) {
    constexpr double kLargestPx = 10, kBlurPx = 2;
    double clear = kLargestPx + kBlurPx;
    for (const auto& marker : markers)
        for (const cv::Point2f& other : marker) {
            const auto off = other - corner;
            clear = std::min(clear, std::max<double>(std::abs(off.x), std::abs(off.y)));
        }
    const int half = std::max(1, static_cast<int>(clear - kBlurPx));
    std::vector<cv::Point2f> one{corner};
    cv::cornerSubPix(grey, one, {half, half}, {-1, -1},
                     {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 40, 0.001});
    corner = one.front();
}

} // namespace

BoardView findCharuco(const GreyBytes& picture, const Board& board, const std::string& name) {
    const cv::Mat grey(picture.height, picture.width, CV_8U, picture.pixels);
    const auto dictionary = dictionaryOf(*board.markers);
    const auto squares =
        cv::aruco::CharucoBoard::create(board.columns + 1, board.rows + 1, 1.0F,
                                        static_cast<float>(board.markers->share), dictionary);
    std::vector<std::vector<cv::Point2f>> markers;
    std::vector<int> markerIds, ids;
    std::vector<cv::Point2f> corners;
    cv::aruco::detectMarkers(grey, dictionary, markers, markerIds);
    BoardView view{name, {}, {}};
    if (markerIds.empty()) return view;
    cv::aruco::interpolateCornersCharuco(markers, markerIds, grey, squares, corners, ids);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        refine(grey, markers, corners[i]);
        view.ids.push_back(ids[i]);
        view.pixels.emplace_back(corners[i].x, corners[i].y);
    }
    return view;
}

#else

BoardView findCharuco(const GreyBytes&, const Board&, const std::string&) {
    throw Refusal("ChArUco boards need OpenCV's aruco module, which this program was built without "
                  "(use a chessboard)");
}

#endif

} // namespace autostereo::calibrate

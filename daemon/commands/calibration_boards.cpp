#include "daemon/commands/calibration_boards.hpp"

#include "config/units.hpp"
#include "daemon/commands/board_gatherer.hpp"
#include "daemon/commands/live_boards.hpp"
#include "daemon/wiring.hpp"
#include "devices/replay_feed.hpp"

#include <array>
#include <cstdio>

#include <unistd.h>

namespace autostereo::daemon {

namespace {

/// "picture 3 of 20", where somebody watches.
class Progress {
  public:
    explicit Progress(std::size_t all) : all_(all), shown_(::isatty(STDERR_FILENO) != 0) {}
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() {
        if (shown_ && done_ > 0) std::fputc('\n', stderr);
    }
    void next() {
        ++done_;
        if (shown_) std::fprintf(stderr, "\rpicture %zu of %zu", done_, all_);
    }

  private:
    std::size_t all_, done_ = 0;
    bool shown_;
};

void lookInFiles(const BoardOptions& options, const calibrate::Board& board, FoundBoards& found) {
    Progress progress(options.depth.size() + options.color.size());
    BoardGatherer depth(board, found, true), color(board, found, false);
    std::vector<std::optional<std::size_t>> depthPlaces;
    for (const auto& file : options.depth) {
        progress.next();
        depthPlaces.push_back(depth.look(devices::readGrey(file), file.string()));
    }
    for (std::size_t i = 0; i < options.color.size(); ++i) {
        progress.next();
        const auto& file = options.color[i];
        const auto place = color.look(devices::readGrey(file), file.string());
        if (place && i < depthPlaces.size() && depthPlaces[i])
            found.views.pairs.emplace_back(*depthPlaces[i], *place);
    }
}

void lookInInput(const BoardOptions& options, const calibrate::Board& board, FoundBoards& found) {
    SceneOptions scene;
    scene.input = options.input;
    devices::ReplayFeed feed(openScene(configuration(scene)), {}, false);
    Progress progress(options.views);
    BoardGatherer depth(board, found, true), color(board, found, false);
    for (std::uint64_t taken = 0, index = 0; taken < options.views && !feed.ended(); ++index) {
        const auto pair = feed.next(std::chrono::milliseconds(0));
        if (!pair || index % options.every != 0) continue;
        ++taken;
        progress.next();
        const std::string name = "frame " + std::to_string(index);
        const auto depthPlace = depth.lookAtDepth(pair->depth, name);
        auto view = color.find(devices::greyOf(pair->color), name + " (colour)");
        if (!view) continue;
        const std::size_t colorPlace = color.take(std::move(*view), pair->color);
        if (depthPlace) found.views.pairs.emplace_back(*depthPlace, colorPlace);
    }
}

calibrate::Markers markersOf(const BoardOptions& options) {
    calibrate::Markers markers;
    char rest = 0;
    int again = 0;
    const int fields = std::sscanf(options.dictionary->c_str(), "%1dx%1d_%4d%c", &markers.bits,
                                   &again, &markers.count, &rest);
    const bool isKnown = fields == 3 && again == markers.bits && markers.bits >= 4 &&
                         markers.bits <= 7 &&
                         (markers.count == 50 || markers.count == 100 || markers.count == 250 ||
                          markers.count == 1000);
    if (!isKnown)
        throw UsageError("--dictionary: " + *options.dictionary +
                         " is not known (allowed 4x4_50 to 7x7_1000)");
    markers.share = options.markerMm / options.squareMm;
    if (!(markers.share > 0 && markers.share < 1))
        throw UsageError("--marker-mm: has to be smaller than the square");
    return markers;
}

} // namespace

calibrate::Board boardOf(const BoardOptions& options) {
    calibrate::Board board;
    char rest = 0;
    const int fields =
        std::sscanf(options.board.c_str(), "%2dx%2d%c", &board.columns, &board.rows, &rest);
    if (fields != 2 || board.columns < 3 || board.rows < 3)
        throw UsageError("--board: " + options.board +
                         " is no board (allowed inner corners as COLUMNSxROWS, 3x3 or more)");
    board.squareM = config::units::metresFromMm(options.squareMm);
    if (options.dictionary) board.markers = markersOf(options);
    return board;
}

void requireSizesOf(const calib::SensorRig& rig, const calibrate::PictureSizes& seen) {
    const auto require = [](const char* which, const calib::Intrinsics& is, int width, int height) {
        if (is.width == width && is.height == height) return;
        throw UsageError(std::string("--rig: its ") + which + " camera is " +
                         std::to_string(is.width) + "x" + std::to_string(is.height) +
                         ", the input's " + std::to_string(width) + "x" + std::to_string(height));
    };
    require("depth", rig.depth.intrinsics, seen.depthWidth, seen.depthHeight);
    require("colour", rig.color.intrinsics, seen.colorWidth, seen.colorHeight);
}

FoundBoards findBoards(const BoardOptions& options) {
    const bool hasFiles = !options.depth.empty() || !options.color.empty();
    if (hasFiles == options.input.has_value())
        throw UsageError("give pictures (--depth, --color) or an --input, one of them");
    if (options.live && !options.input) throw UsageError("--live: an --input has to be watched");
    const calibrate::Board board = boardOf(options);
    FoundBoards found;
    if (options.live)
        watchBoards(options, board, found);
    else
        options.input ? lookInInput(options, board, found) : lookInFiles(options, board, found);
    return found;
}

} // namespace autostereo::daemon

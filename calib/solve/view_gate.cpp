#include "calib/solve/view_gate.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace autostereo::calibrate {

namespace {

constexpr double kMoving = 0.05;   // of the width in a second: half a pixel of 640 in 1/60 s
constexpr double kBlurredPx = 4;   // corners are then found to a few tenths of a pixel only
constexpr double kElsewhere = 0.1; // of the picture's width or height
constexpr double kOtherSize = 0.25, kOtherTurn = 0.08; // log2
constexpr double kTurned = 0.1; // log2: perspective that tells the focal length
constexpr std::size_t kTurnedViews = 4;

/// A corner's place in the picture by its number on the board.
std::optional<glm::dvec2> placeOf(const BoardView& view, int id) {
    const auto found = std::ranges::find(view.ids, id);
    if (found == view.ids.end()) return std::nullopt;
    return view.pixels[static_cast<std::size_t>(found - view.ids.begin())];
}

/// Root mean square of what corners that both views have moved by; none: far.
double moved(const BoardView& from, const BoardView& to) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < to.size(); ++i)
        if (const auto before = placeOf(from, to.ids[i])) {
            const glm::dvec2 step = to.pixels[i] - *before;
            sum += glm::dot(step, step);
            ++count;
        }
    constexpr double kFar = 1e9;
    return count > 0 ? std::sqrt(sum / count) : kFar;
}

} // namespace

double edgeWidth(const GreyImage& image, const BoardView& view, const Board& board) {
    const auto at = [&](int x, int y) {
        return static_cast<double>(
            image.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(x)]);
    };
    std::vector<double> widths;
    for (std::size_t i = 0; i < view.size(); ++i) {
        const auto next = placeOf(view, view.ids[i] + 1);
        if (!next || view.ids[i] % board.columns == board.columns - 1) continue;
        // A square about a corner, half as wide as the board's squares, holds two edges.
        const int reach =
            std::clamp(static_cast<int>(glm::distance(*next, view.pixels[i]) / 2), 2, 40);
        const int x0 = static_cast<int>(std::lround(view.pixels[i].x)),
                  y0 = static_cast<int>(std::lround(view.pixels[i].y));
        if (x0 - reach < 1 || y0 - reach < 1 || x0 + reach > image.width - 2 ||
            y0 + reach > image.height - 2)
            continue;
        double least = 1e9, most = 0, steepest = 0;
        for (int y = y0 - reach; y <= y0 + reach; ++y)
            for (int x = x0 - reach; x <= x0 + reach; ++x) {
                least = std::min(least, at(x, y));
                most = std::max(most, at(x, y));
                steepest = std::max(
                    steepest,
                    std::hypot(at(x + 1, y) - at(x - 1, y), at(x, y + 1) - at(x, y - 1)) / 2);
            }
        if (steepest > 0) widths.push_back((most - least) / steepest);
    }
    if (widths.empty()) return 0;
    const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
    std::ranges::nth_element(widths, middle);
    return *middle;
}

ViewGate::ViewGate(const Board& board, int width, int height)
    : board_(board), width_(width), height_(height) {}

ViewGate::Verdict ViewGate::judge(const BoardView& view, double timeS, double edgeWidthPx) {
    const double allowed = kMoving * width_ * (timeS - lastS_);
    const double step = moved(last_, view);
    last_ = view;
    lastS_ = timeS;
    if (!(step <= allowed)) return Verdict::Moving;
    if (edgeWidthPx > kBlurredPx) return Verdict::Blurred;
    const auto pose = poseOf(view);
    if (!pose ||
        !std::ranges::all_of(taken_, [&](const Pose& was) { return isUnlike(was, *pose); }))
        return Verdict::SeenBefore;
    note(view, *pose);
    return Verdict::Take;
}

/// By the outermost corners that are seen of the board's middle rows and columns and its sides.
std::optional<ViewGate::Pose> ViewGate::poseOf(const BoardView& view) const {
    if (view.size() < 4) return std::nullopt;
    int left = board_.columns, right = -1, top = board_.rows, bottom = -1;
    for (const int id : view.ids) {
        left = std::min(left, id % board_.columns);
        right = std::max(right, id % board_.columns);
        top = std::min(top, id / board_.columns);
        bottom = std::max(bottom, id / board_.columns);
    }
    const auto corner = [&](int column, int row) {
        return placeOf(view, row * board_.columns + column);
    };
    const auto a = corner(left, top), b = corner(right, top), c = corner(left, bottom),
               d = corner(right, bottom);
    if (!a || !b || !c || !d || left == right || top == bottom) return std::nullopt;
    const glm::dvec2 middle = (*a + *b + *c + *d) / 4.0;
    const double diagonal = (glm::distance(*a, *d) + glm::distance(*b, *c)) / 2;
    return Pose{middle.x / width_, middle.y / height_,
                std::log2(diagonal / std::hypot(width_, height_)),
                std::log2(glm::distance(*a, *b) / glm::distance(*c, *d)),
                std::log2(glm::distance(*a, *c) / glm::distance(*b, *d))};
}

bool ViewGate::isUnlike(const Pose& a, const Pose& b) {
    return std::hypot(a.x - b.x, a.y - b.y) > kElsewhere ||
           std::abs(a.size - b.size) > kOtherSize ||
           std::hypot(a.leans - b.leans, a.turns - b.turns) > kOtherTurn;
}

void ViewGate::note(const BoardView& view, const Pose& pose) {
    taken_.push_back(pose);
    for (const glm::dvec2& pixel : view.pixels) {
        const auto third = [](double place, int size) {
            return static_cast<std::size_t>(std::clamp(static_cast<int>(3 * place / size), 0, 2));
        };
        cells_.at(3 * third(pixel.y, height_) + third(pixel.x, width_)) = true;
    }
}

double ViewGate::covered() const {
    return static_cast<double>(std::ranges::count(cells_, true)) /
           static_cast<double>(cells_.size());
}

std::optional<std::string> ViewGate::wanted() const {
    constexpr std::array<const char*, 9> kCells{"upper left",  "upper middle", "upper right",
                                                "middle left", "middle",       "middle right",
                                                "lower left",  "lower middle", "lower right"};
    const auto turned = std::ranges::count_if(
        taken_, [](const Pose& pose) { return std::hypot(pose.leans, pose.turns) > kTurned; });
    if (static_cast<std::size_t>(turned) < std::min(kTurnedViews, taken_.size()))
        return "tilt the board";
    for (std::size_t i = 0; i < cells_.size(); ++i)
        if (!cells_.at(i)) return std::string("to the picture's ") + kCells.at(i);
    return std::nullopt;
}

} // namespace autostereo::calibrate

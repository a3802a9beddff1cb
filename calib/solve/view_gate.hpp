#pragma once

#include "calib/solve/board_detector.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace autostereo::calibrate {

/// Width of the board's edges in a picture, pixels: the median over its corners of what brightness
/// takes to go from dark to light (their difference over the steepest slope). 1 to 2 is sharp.
[[nodiscard]] double edgeWidth(const GreyImage& image, const BoardView& view, const Board& board);

/// Which of the views that a camera sees one after the other are worth taking: still, sharp, and
/// unlike those that were taken; and what is still missing. Pure but for what it remembers.
class ViewGate {
  public:
    enum class Verdict { Take, Moving, Blurred, SeenBefore };

    ViewGate(const Board& board, int width, int height);

    /// Of the next view, at a time of any clock, s; it counts as taken where the answer is Take.
    [[nodiscard]] Verdict judge(const BoardView& view, double timeS, double edgeWidthPx);
    /// Share of the picture's ninths in which corners of taken views lie.
    [[nodiscard]] double covered() const;
    /// What the next view should be, in words for whoever holds the board; nothing: enough.
    [[nodiscard]] std::optional<std::string> wanted() const;

  private:
    /// Where the board is in the picture and how it is turned.
    struct Pose {
        double x, y;         ///< middle, shares of the picture
        double size;         ///< log2 of its diagonal over the picture's
        double leans, turns; ///< log2 of opposite sides' lengths: top over bottom, left over right
    };
    [[nodiscard]] std::optional<Pose> poseOf(const BoardView& view) const;
    [[nodiscard]] static bool isUnlike(const Pose& a, const Pose& b);
    void note(const BoardView& view, const Pose& pose);

    Board board_;
    int width_, height_;
    BoardView last_;
    double lastS_ = 0;
    std::vector<Pose> taken_;
    std::array<bool, 9> cells_{}; ///< of the picture, row by row
};

} // namespace autostereo::calibrate

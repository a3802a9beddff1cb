#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace autostereo::test {

/// Tumbling Es, black on white, one in the middle of each cell of a square chart, each at a random
/// place within a pixel and turned at random. Light is linear, 0 to 1; row by row from the top.
class LetterChart {
  public:
    static constexpr int kCell = 48, kCells = 4, kSize = kCell * kCells; // pixels
    static constexpr int kLetters = kCells * kCells;

    /// `size`: of a letter, five strokes, pixels; at most kCell / 2.
    LetterChart(double size, std::mt19937& random) : size_(size) {
        std::uniform_real_distribution<double> place(-0.5, 0.5);
        std::uniform_int_distribution<int> turn(0, 3);
        for (Letter& letter : letters_)
            letter = {place(random), place(random), turn(random)};
    }

    /// As a perfect display would show it, pixels' mean light, with every letter turned on by so
    /// many quarters: 0 is the chart itself, 1 to 3 what else its letters could be.
    [[nodiscard]] std::vector<double> light(int quarters) const {
        std::vector<double> picture(static_cast<std::size_t>(kSize) * kSize);
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const Letter& letter = letters_.at(cell(x, y));
                const int turn = (letter.turn + quarters) % 4;
                picture[index(x, y)] = 1 - ink(letter, turn, x % kCell, y % kCell);
            }
        return picture;
    }

    /// How many letters are named right by an observer who sees the chart with white noise of
    /// standard deviation `noise` on each pixel and takes, of how each letter would look turned by
    /// 0 to 3 quarters more, what is nearest (least squares: the most likely one).
    [[nodiscard]] static int named(const std::vector<double>& seen,
                                   const std::array<std::vector<double>, 4>& looks, double noise,
                                   std::mt19937& random) {
        std::normal_distribution<double> grain(0, 1);
        std::array<std::array<double, 4>, kLetters> off{};
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const double level = seen[index(x, y)] + noise * grain(random);
                for (std::size_t turn = 0; turn < 4; ++turn)
                    off.at(cell(x, y)).at(turn) += std::pow(level - looks.at(turn)[index(x, y)], 2);
            }
        return static_cast<int>(std::ranges::count_if(
            off, [](const auto& each) { return std::ranges::min_element(each) == each.begin(); }));
    }

  private:
    struct Letter {
        double x, y; ///< off the cell's middle, pixels
        int turn;    ///< quarter turns
    };

    static std::size_t index(int x, int y) {
        const int at = y * kSize + x;
        return static_cast<std::size_t>(at);
    }
    static std::size_t cell(int x, int y) {
        const int cell = y / kCell * kCells + x / kCell;
        return static_cast<std::size_t>(cell);
    }
    static double overlap(double a, double b, double from, double to) {
        return std::max(0.0, std::min(b, to) - std::max(a, from));
    }
    /// Share of a pixel of a cell that is black: an upright stroke and three that leave it.
    [[nodiscard]] double ink(const Letter& letter, int turn, int x, int y) const {
        // The pixel as the letter sees it, whose corner is at 0, strokes in pixels.
        double u = x - (kCell / 2.0 + letter.x), v = y - (kCell / 2.0 + letter.y);
        for (int quarter = 0; quarter < turn; ++quarter) {
            const double before = u;
            u = v;
            v = -before - 1;
        }
        u += size_ / 2;
        v += size_ / 2;
        const double stroke = size_ / 5;
        const double stem = overlap(u, u + 1, 0, stroke) * overlap(v, v + 1, 0, size_);
        double bars = 0;
        for (const int bar : {0, 2, 4})
            bars += overlap(v, v + 1, bar * stroke, (bar + 1) * stroke);
        return stem + overlap(u, u + 1, stroke, size_) * bars;
    }
    double size_;
    std::array<Letter, kLetters> letters_{};
};

} // namespace autostereo::test

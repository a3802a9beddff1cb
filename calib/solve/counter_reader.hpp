#pragma once

#include "calib/counter_chart.hpp"
#include "calib/solve/board_detector.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace autostereo::calibrate {

/// Reads the numbers of a CounterChart in the pictures of a camera that stands still, upright to
/// within 90 degrees. Between the chessboard's corners places are interpolated, so neither the lens
/// nor the perspective has to be known. Reentrant.
class CounterReader {
  public:
    enum class Doubt {
        Unseen,  ///< hardly any contrast, or another picture size than the board's
        Changing ///< a bit is between black and white: exposed while the number changed
    };
    /// Differences of a bit's two blocks, of 255 levels: noise of single pixels averages far below.
    static constexpr double kLeastContrast = 12;
    /// Of the greatest difference; what vignetting takes from the others is less.
    static constexpr double kSure = 0.5;

    /// `board`: a picture of the chart's board; none where it is not wholly seen.
    [[nodiscard]] static std::optional<CounterReader> find(const GreyImage& board);

    [[nodiscard]] std::variant<unsigned, Doubt> read(const GreyImage& picture) const;

  private:
    static constexpr int kSamples = 8; ///< each way, over the middle half of a block
    using Block = std::array<std::size_t, kSamples * kSamples>; ///< pixels; outside: the last one

    CounterReader() = default;
    [[nodiscard]] static double mean(const GreyImage& picture, const Block& block);

    int width_ = 0, height_ = 0;
    std::vector<Block> bits_, inverses_;
};

} // namespace autostereo::calibrate

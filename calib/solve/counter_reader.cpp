#include "calib/solve/counter_reader.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace autostereo::calibrate {

namespace {

using calib::CounterChart;

/// Where a place of the panel lies in the camera's picture: bilinear between the four corners
/// around it, and beyond the outermost ones as between these.
class PanelInPicture {
  public:
    explicit PanelInPicture(std::vector<glm::dvec2> corners) : corners_(std::move(corners)) {}

    [[nodiscard]] glm::dvec2 pixel(const glm::dvec2& place) const {
        const glm::dvec2 origin = CounterChart::corner(0, 0);
        const glm::dvec2 square = CounterChart::corner(1, 1) - origin;
        const glm::dvec2 at = (place - origin) / square;
        const int column =
            std::clamp(static_cast<int>(std::floor(at.x)), 0, CounterChart::kCornerColumns - 2);
        const int row =
            std::clamp(static_cast<int>(std::floor(at.y)), 0, CounterChart::kCornerRows - 2);
        const double x = at.x - column, y = at.y - row;
        return glm::mix(glm::mix(corner(column, row), corner(column + 1, row), x),
                        glm::mix(corner(column, row + 1), corner(column + 1, row + 1), x), y);
    }

  private:
    [[nodiscard]] const glm::dvec2& corner(int column, int row) const {
        return corners_[static_cast<std::size_t>(row) * CounterChart::kCornerColumns +
                        static_cast<std::size_t>(column)];
    }
    std::vector<glm::dvec2> corners_;
};

} // namespace

std::optional<CounterReader> CounterReader::find(const GreyImage& board) {
    const Board squares{CounterChart::kCornerColumns, CounterChart::kCornerRows, 1, {}};
    auto view = findBoard(board, squares, "panel");
    if (!view || view->pixels.size() != static_cast<std::size_t>(squares.corners()))
        return std::nullopt;
    if (view->pixels.front().y > view->pixels.back().y) std::ranges::reverse(view->pixels);
    const PanelInPicture panel(std::move(view->pixels));
    CounterReader reader;
    reader.width_ = board.width;
    reader.height_ = board.height;
    const glm::dvec2 last(board.width - 1, board.height - 1);
    for (int bit = 0; bit < CounterChart::kBits; ++bit)
        for (const bool inverse : {false, true}) {
            Block block{};
            for (int i = 0; i < kSamples * kSamples; ++i) {
                const glm::dvec2 within =
                    (glm::dvec2(i % kSamples, i / kSamples) + 0.5) / double{kSamples} - 0.5;
                const glm::dvec2 pixel =
                    glm::clamp(glm::round(panel.pixel(CounterChart::blockOf(bit, inverse) +
                                                      within * CounterChart::halfBlock())),
                               glm::dvec2(0), last);
                block.at(static_cast<std::size_t>(i)) =
                    static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(board.width) +
                    static_cast<std::size_t>(pixel.x);
            }
            (inverse ? reader.inverses_ : reader.bits_).push_back(block);
        }
    return reader;
}

double CounterReader::mean(const GreyImage& picture, const Block& block) {
    double sum = 0;
    for (const std::size_t at : block)
        sum += picture.values[at];
    return sum / static_cast<double>(block.size());
}

std::variant<unsigned, CounterReader::Doubt> CounterReader::read(const GreyImage& picture) const {
    if (picture.width != width_ || picture.height != height_) return Doubt::Unseen;
    unsigned gray = 0;
    double least = std::numeric_limits<double>::infinity(), greatest = 0;
    for (std::size_t bit = 0; bit < bits_.size(); ++bit) {
        const double difference = mean(picture, bits_[bit]) - mean(picture, inverses_[bit]);
        least = std::min(least, std::abs(difference));
        greatest = std::max(greatest, std::abs(difference));
        if (difference > 0) gray |= 1U << bit;
    }
    if (greatest < kLeastContrast) return Doubt::Unseen;
    if (least < kSure * greatest) return Doubt::Changing;
    return CounterChart::numberOf(gray);
}

} // namespace autostereo::calibrate

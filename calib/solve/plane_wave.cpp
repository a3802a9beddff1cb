#include "calib/solve/plane_wave.hpp"

#include "calib/solve/least_squares.hpp"

#include <opencv2/core.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace autostereo::calibrate {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kPadding = 2; // the spectrum is sampled so much finer than the cells allow

struct Place {
    double x, y;
};
Place placeOf(const WaveCells& cells, int column, int row) {
    return {(column + 0.5) / cells.columns - 0.5, 0.5 - (row + 0.5) / cells.rows};
}

std::size_t at(const WaveCells& cells, int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells.columns) +
           static_cast<std::size_t>(column);
}

/// Slopes of the strongest wave, to a fraction of a cycle over the panel.
std::pair<double, double> strongest(const WaveCells& cells) {
    cv::Mat spectrum = cv::Mat::zeros(kPadding * cells.rows, kPadding * cells.columns, CV_64FC2);
    for (int row = 0; row < cells.rows; ++row)
        for (int column = 0; column < cells.columns; ++column) {
            const std::complex<double> value = cells.values[at(cells, column, row)];
            spectrum.at<cv::Vec2d>(row, column) = {value.real(), value.imag()};
        }
    cv::dft(spectrum, spectrum);
    double most = -1;
    int bestColumn = 0, bestRow = 0;
    for (int row = 0; row < spectrum.rows; ++row)
        for (int column = 0; column < spectrum.cols; ++column) {
            const cv::Vec2d& value = spectrum.at<cv::Vec2d>(row, column);
            const double power = value.dot(value);
            if (power <= most) continue;
            most = power;
            bestColumn = column;
            bestRow = row;
        }
    const auto folded = [](int index, int size) { return 2 * index < size ? index : index - size; };
    // The spectrum's rows run down, slopeY runs up.
    return {folded(bestColumn, spectrum.cols) / static_cast<double>(kPadding),
            -folded(bestRow, spectrum.rows) / static_cast<double>(kPadding)};
}

struct Block {
    std::complex<double> sum{0};
    Place middle{0, 0};
    int cells = 0;
};

/// What is left in each block once the wave is taken out.
std::vector<Block> blocksOf(const WaveCells& cells, const PlaneWave& wave) {
    constexpr int kBlocks = PlaneWave::kBlocks;
    std::vector<Block> blocks(static_cast<std::size_t>(kBlocks) * kBlocks);
    for (int row = 0; row < cells.rows; ++row)
        for (int column = 0; column < cells.columns; ++column) {
            const std::complex<double> value = cells.values[at(cells, column, row)];
            if (value == 0.0) continue;
            const Place place = placeOf(cells, column, row);
            const double cycles = wave.slopeX * place.x + wave.slopeY * place.y + wave.middle;
            const int across = column * kBlocks / cells.columns, down = row * kBlocks / cells.rows;
            Block& block =
                blocks[static_cast<std::size_t>(down) * kBlocks + static_cast<std::size_t>(across)];
            block.sum += value * std::polar(1.0, -kTurn * cycles);
            block.middle = {block.middle.x + place.x, block.middle.y + place.y};
            ++block.cells;
        }
    for (Block& block : blocks)
        if (block.cells > 0)
            block.middle = {block.middle.x / block.cells, block.middle.y / block.cells};
    return blocks;
}

double cyclesOf(const Block& block) { return std::arg(block.sum) / kTurn; }

/// One step of least squares over the blocks' phases; false where they do not determine a wave.
bool refine(PlaneWave& wave, const std::vector<Block>& blocks) {
    NormalEquations equations(3);
    for (const Block& block : blocks)
        if (block.cells > 0)
            equations.add(std::array<Slope, 3>{{{0, block.middle.x}, {1, block.middle.y}, {2, 1}}},
                          cyclesOf(block), std::abs(block.sum));
    equations.complete();
    const auto step = equations.matrix.solved(equations.right, 0);
    auto inverse = equations.matrix.inverse();
    if (!step || !inverse || equations.residuals <= 3) return false;
    wave.slopeX += (*step)[0];
    wave.slopeY += (*step)[1];
    wave.middle += (*step)[2];
    inverse->scale(equations.cost / static_cast<double>(equations.residuals - 3));
    wave.covariance = std::move(*inverse);
    return true;
}

} // namespace

std::optional<PlaneWave> fitPlaneWave(const WaveCells& cells, double leastContrast) {
    constexpr int kSteps = 8;
    const auto unseen = std::count(cells.values.begin(), cells.values.end(), 0.0);
    const auto seen = static_cast<std::ptrdiff_t>(cells.values.size()) - unseen;
    if (4 * seen < static_cast<std::ptrdiff_t>(cells.values.size())) return std::nullopt;
    PlaneWave wave;
    std::tie(wave.slopeX, wave.slopeY) = strongest(cells);
    std::complex<double> all{0};
    for (const Block& block : blocksOf(cells, wave))
        all += block.sum;
    wave.middle = std::arg(all) / kTurn;
    for (int i = 0; i < kSteps; ++i)
        if (!refine(wave, blocksOf(cells, wave))) return std::nullopt;

    double squares = 0, weight = 0;
    all = 0;
    for (const Block& block : blocksOf(cells, wave)) {
        auto& left = wave.residual.emplace_back();
        if (block.cells > 0) left = cyclesOf(block);
        all += block.sum;
        squares += block.cells * left.value_or(0) * left.value_or(0);
        weight += block.cells;
    }
    wave.rms = std::sqrt(squares / weight);
    wave.contrast = std::abs(all) / static_cast<double>(seen);
    if (wave.contrast < leastContrast) return std::nullopt;
    return wave;
}

} // namespace autostereo::calibrate

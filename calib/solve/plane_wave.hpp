#pragma once

#include "calib/solve/symmetric_matrix.hpp"

#include <array>
#include <complex>
#include <optional>
#include <vector>

namespace autostereo::calibrate {

/// Fringes over a panel that is cut into equal cells: in each the mean of amplitude x e^(2 pi i
/// cycles), amplitude 1 being full contrast; 0 where nothing was seen. Rows from the top.
struct WaveCells {
    int columns = 0;
    int rows = 0;
    std::vector<std::complex<double>> values;
};

/// cycles(x, y) = slopeX x + slopeY y + middle, x rightwards and y upwards from the panel's centre,
/// its width and height being 1.
struct PlaneWave {
    static constexpr int kBlocks = 16; ///< each way, in which `residual` is given

    double slopeX = 0;
    double slopeY = 0;
    double middle = 0;          ///< a whole cycle is nothing
    SymmetricMatrix covariance; ///< of these three, from the blocks' scatter
    double contrast = 0;        ///< of what moves in step with the wave, 0 to 1
    double rms = 0;             ///< of the blocks, cycles
    /// Cycles, -1/2 to 1/2: a block each, rows from the top; nothing where none of it was seen.
    std::vector<std::optional<double>> residual;
};

/// The strongest wave, found in the spectrum, then fitted to the phases of the blocks. None where
/// less than a quarter of the panel was seen, or no wave reaches `leastContrast`.
[[nodiscard]] std::optional<PlaneWave> fitPlaneWave(const WaveCells& cells, double leastContrast);

} // namespace autostereo::calibrate

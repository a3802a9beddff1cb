#pragma once

#include <cstdint>
#include <ostream>
#include <span>

namespace autostereo::test {

/// Borrowed 8-bit picture, rows tightly packed, top row first; 1 to 4 interleaved channels.
struct ImageView {
    std::span<const std::uint8_t> samples; ///< width * height * channels
    int width = 0;                         ///< pixels
    int height = 0;
    int channels = 3;
};

/// How far two pictures of the same shape lie apart, over all samples; differences in 1/255.
struct ImageDifference {
    int max = 0;
    int maxX = 0; ///< pixel and channel of the first sample that differs by `max`
    int maxY = 0;
    int maxChannel = 0;
    double mean = 0.0;       ///< of the absolute differences
    double psnrDb = 0.0;     ///< infinite when nothing differs
    double shareAbove = 0.0; ///< part of the samples, 0..1, that differ by more than the threshold
};

/// Compares sample by sample. Throws std::invalid_argument when the shapes differ, or when a
/// picture does not hold as many samples as its shape says, or none at all. Reentrant.
[[nodiscard]] ImageDifference compareImages(const ImageView& actual, const ImageView& expected,
                                            int threshold = 16);

/// One line for a failing assertion: figures, and where to look.
std::ostream& operator<<(std::ostream& out, const ImageDifference& difference);

} // namespace autostereo::test

#include "tests/support/image_compare.hpp"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

namespace autostereo::test {

namespace {

std::string shapeOf(const ImageView& image) {
    return std::to_string(image.width) + 'x' + std::to_string(image.height) + 'x' +
           std::to_string(image.channels) + " in " + std::to_string(image.samples.size()) +
           " samples";
}

void requireComparable(const ImageView& actual, const ImageView& expected) {
    const auto shaped = [](const ImageView& image) {
        return image.width > 0 && image.height > 0 && image.channels > 0 &&
               image.samples.size() == static_cast<std::size_t>(image.width) *
                                           static_cast<std::size_t>(image.height) *
                                           static_cast<std::size_t>(image.channels);
    };
    if (!shaped(actual) || !shaped(expected) || actual.width != expected.width ||
        actual.height != expected.height || actual.channels != expected.channels)
        throw std::invalid_argument("cannot compare " + shapeOf(actual) + " with " +
                                    shapeOf(expected));
}

} // namespace

ImageDifference compareImages(const ImageView& actual, const ImageView& expected, int threshold) {
    requireComparable(actual, expected);
    std::size_t maxAt = 0;
    std::uint64_t above = 0;
    std::uint64_t sum = 0;
    std::uint64_t sumOfSquares = 0;
    ImageDifference result;
    for (std::size_t i = 0; i < actual.samples.size(); ++i) {
        const int difference = std::abs(actual.samples[i] - expected.samples[i]);
        if (difference > result.max) {
            result.max = difference;
            maxAt = i;
        }
        above += difference > threshold ? 1U : 0U;
        sum += static_cast<std::uint64_t>(difference);
        sumOfSquares += static_cast<std::uint64_t>(difference) * static_cast<unsigned>(difference);
    }
    const auto channels = static_cast<std::size_t>(actual.channels);
    const auto width = static_cast<std::size_t>(actual.width);
    result.maxChannel = static_cast<int>(maxAt % channels);
    result.maxX = static_cast<int>(maxAt / channels % width);
    result.maxY = static_cast<int>(maxAt / channels / width);

    const auto count = static_cast<double>(actual.samples.size());
    result.mean = static_cast<double>(sum) / count;
    result.shareAbove = static_cast<double>(above) / count;
    result.psnrDb =
        sumOfSquares == 0
            ? std::numeric_limits<double>::infinity()
            : 10.0 * std::log10(255.0 * 255.0 * count / static_cast<double>(sumOfSquares));
    return result;
}

std::ostream& operator<<(std::ostream& out, const ImageDifference& difference) {
    return out << "max " << difference.max << " at (" << difference.maxX << ", " << difference.maxY
               << ") channel " << difference.maxChannel << ", mean " << difference.mean << ", PSNR "
               << difference.psnrDb << " dB, " << 100.0 * difference.shareAbove
               << " % above the threshold";
}

} // namespace autostereo::test

#include "tests/replay/pictures.hpp"

#include "devices/replay/image_files.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>

namespace autostereo::test {

namespace {

using devices::ImageFormat;
using devices::ImageHeader;

std::vector<std::byte> decode(const std::string& file, ImageFormat format, ImageHeader& header) {
    devices::ImageReader reader;
    header = reader.open(file);
    if (header.format != format) throw std::runtime_error(file + ": wrong kind of picture");
    std::vector<std::byte> pixels(header.bytes());
    reader.decode(pixels);
    return pixels;
}

} // namespace

ColorPicture readColor(const std::string& file) {
    ImageHeader header;
    const auto rgba = decode(file, ImageFormat::Rgba8, header);
    ColorPicture picture{header.width, header.height, {}};
    picture.rgb.reserve(rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < rgba.size(); ++i)
        if (i % 4 != 3) picture.rgb.push_back(static_cast<std::uint8_t>(rgba[i]));
    return picture;
}

DepthPicture readDepth(const std::string& file) {
    ImageHeader header;
    const auto grey = decode(file, ImageFormat::Grey16, header);
    DepthPicture picture{header.width, header.height, {}};
    picture.millimetres.resize(grey.size() / 2);
    std::ranges::copy(grey, std::as_writable_bytes(std::span(picture.millimetres)).begin());
    return picture;
}

std::string writeColor(const std::string& file, int width, int height,
                       const std::function<Rgb(int, int)>& color) {
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto [red, green, blue] = color(x, y);
            pixels.insert(pixels.end(), {red, green, blue});
        }
    devices::writePng(file, {{ImageFormat::Rgb8, width, height}, std::as_bytes(std::span(pixels))});
    return file;
}

std::string writeDepth(const std::string& file, int width, int height,
                       const std::function<int(int, int)>& millimetres) {
    std::vector<std::uint16_t> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            pixels.push_back(static_cast<std::uint16_t>(millimetres(x, y)));
    devices::writePng(file,
                      {{ImageFormat::Grey16, width, height}, std::as_bytes(std::span(pixels))});
    return file;
}

double contrast(const ColorPicture& picture) {
    double sum = 0, sumOfSquares = 0;
    for (std::size_t i = 1; i < picture.rgb.size(); i += 3) {
        sum += picture.rgb[i];
        sumOfSquares += picture.rgb[i] * picture.rgb[i];
    }
    const double count = static_cast<double>(picture.rgb.size()) / 3;
    return std::sqrt(std::max(0.0, sumOfSquares / count - sum * sum / count / count));
}

int shiftOf(const Block& block, const ColorPicture& from, const ColorPicture& to, int reach) {
    auto least = std::numeric_limits<std::int64_t>::max();
    int best = 0;
    for (int shift = -reach; shift <= reach; ++shift) {
        std::int64_t sum = 0;
        for (int y = block.y; y < block.y + block.height; ++y)
            for (int x = block.x; x < block.x + block.width; ++x)
                for (int channel = 0; channel < 3; ++channel) {
                    const int difference = from.at(x, y)[channel] - to.at(x + shift, y)[channel];
                    sum += difference * difference;
                }
        if (sum < least) {
            least = sum;
            best = shift;
        }
    }
    return best;
}

} // namespace autostereo::test

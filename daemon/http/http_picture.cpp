#include "daemon/http/http_picture.hpp"

#include "devices/replay/image_files.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>

namespace autostereo::daemon {

namespace {

/// The `part`-th of so many equal parts of a side, whole pixels.
std::size_t edge(int part, int parts, int side) {
    return static_cast<std::size_t>(static_cast<long long>(part) * side / parts);
}

std::array<std::uint8_t, 3> meanOf(const gpu::RgbImage& image, std::size_t left, std::size_t right,
                                   std::size_t top, std::size_t bottom) {
    std::array<std::size_t, 3> sum{};
    for (std::size_t y = top; y < bottom; ++y) {
        const std::size_t row = y * static_cast<std::size_t>(image.width);
        for (std::size_t i = 3 * (row + left); i < 3 * (row + right); i += 3)
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += image.pixels[i + c];
    }
    const std::size_t count = std::max<std::size_t>(1, (right - left) * (bottom - top));
    std::array<std::uint8_t, 3> mean{};
    for (std::size_t c = 0; c < 3; ++c)
        mean[c] = static_cast<std::uint8_t>((sum[c] + count / 2) / count);
    return mean;
}

} // namespace

gpu::RgbImage pictureIn(const ControlReply& reply) {
    const auto line = nlohmann::json::parse(reply.line, nullptr, false);
    gpu::RgbImage image;
    if (line.is_object() && reply.bytes)
        image = {line.value("width", 0), line.value("height", 0), *reply.bytes};
    const auto pixels = static_cast<std::size_t>(std::max(0, image.width)) *
                        static_cast<std::size_t>(std::max(0, image.height));
    if (pixels == 0 || image.pixels.size() != 3 * pixels)
        throw std::runtime_error("http: an answer without a picture");
    return image;
}

gpu::RgbImage shrunk(gpu::RgbImage image, int longest) {
    const int side = std::max(image.width, image.height);
    if (side <= longest) return image;
    const auto scaled = [&](int pixels) {
        return std::max(1, static_cast<int>(static_cast<long long>(pixels) * longest / side));
    };
    gpu::RgbImage small{scaled(image.width), scaled(image.height), {}};
    small.pixels.reserve(3 * static_cast<std::size_t>(small.width) *
                         static_cast<std::size_t>(small.height));
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            const auto mean = meanOf(
                image, edge(x, small.width, image.width), edge(x + 1, small.width, image.width),
                edge(y, small.height, image.height), edge(y + 1, small.height, image.height));
            small.pixels.insert(small.pixels.end(), mean.begin(), mean.end());
        }
    return small;
}

std::string pngOf(const gpu::RgbImage& image) {
    return devices::encodePng({{devices::ImageFormat::Rgb8, image.width, image.height},
                               std::as_bytes(std::span(image.pixels))});
}

} // namespace autostereo::daemon

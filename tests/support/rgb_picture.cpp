#include "tests/support/rgb_picture.hpp"

#include "devices/replay/image_files.hpp"

#include <algorithm>
#include <cstddef>

namespace autostereo::test {

RgbPicture readPicture(const std::filesystem::path& file) {
    devices::ImageReader reader;
    const devices::ImageHeader header = reader.open(file);
    std::vector<std::byte> pixels(header.bytes());
    reader.decode(pixels);
    RgbPicture picture{header.width, header.height, {}};
    for (std::size_t i = 0; i < pixels.size(); ++i) // RGBA
        if (i % 4 != 3) picture.rgb.push_back(std::to_integer<std::uint8_t>(pixels[i]));
    return picture;
}

RgbPicture readBackdrop(const std::filesystem::path& file, int width, int height) {
    const RgbPicture whole = readPicture(file);
    const double scale = std::min(static_cast<double>(whole.width) / width,
                                  static_cast<double>(whole.height) / height);
    RgbPicture picture{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 color = texelOf(whole, {scale * x, scale * y});
            for (int c = 0; c < 3; ++c)
                picture.rgb.push_back(static_cast<std::uint8_t>(color[c]));
        }
    return picture;
}

glm::dvec3 texelOf(const RgbPicture& picture, const glm::dvec2& at) {
    const double x = std::clamp(at.x, 0.0, picture.width - 1.001);
    const double y = std::clamp(at.y, 0.0, picture.height - 1.001);
    const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
    const auto pixel = [&](std::size_t i, std::size_t j) {
        const std::uint8_t* p = &picture.rgb[3 * (j * static_cast<std::size_t>(picture.width) + i)];
        return glm::dvec3{p[0], p[1], p[2]};
    };
    const double fx = x - static_cast<double>(column), fy = y - static_cast<double>(row);
    return (1 - fy) * ((1 - fx) * pixel(column, row) + fx * pixel(column + 1, row)) +
           fy * ((1 - fx) * pixel(column, row + 1) + fx * pixel(column + 1, row + 1));
}

} // namespace autostereo::test

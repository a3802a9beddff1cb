#pragma once

#include "tests/support/image_compare.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace autostereo::test {

/// A picture read from a file; top row first, tightly packed.
struct ColorPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;

    [[nodiscard]] const std::uint8_t* at(int x, int y) const {
        return rgb.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                 static_cast<std::size_t>(x));
    }
    [[nodiscard]] ImageView view() const { return {rgb, width, height, 3}; }
    [[nodiscard]] bool operator==(const ColorPicture&) const = default;
};

inline double psnr(const ColorPicture& a, const ColorPicture& b) {
    return compareImages(a.view(), b.view()).psnrDb;
}

struct DepthPicture {
    int width = 0, height = 0;
    std::vector<std::uint16_t> millimetres; ///< 0: none

    [[nodiscard]] int at(int x, int y) const {
        return millimetres[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(x)];
    }
};

/// Throw std::runtime_error where the file is not there, broken or of the other kind.
[[nodiscard]] ColorPicture readColor(const std::string& file);
[[nodiscard]] DepthPicture readDepth(const std::string& file);

struct Rgb {
    std::uint8_t red, green, blue;
};

/// Write PNGs of what a function says about every pixel (x, y); the path.
std::string writeColor(const std::string& file, int width, int height,
                       const std::function<Rgb(int, int)>& color);
std::string writeDepth(const std::string& file, int width, int height,
                       const std::function<int(int, int)>& millimetres);

/// Standard deviation of the green samples: 0 for a flat picture.
[[nodiscard]] double contrast(const ColorPicture& picture);

/// The block whose top left corner is (x, y): how many pixels further right it is found in the
/// other picture, at most `reach` either way, by the least sum of squared differences.
struct Block {
    int x, y, width, height;
};
[[nodiscard]] int shiftOf(const Block& block, const ColorPicture& from, const ColorPicture& to,
                          int reach);

} // namespace autostereo::test

#include "daemon/http/http_picture.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

namespace autostereo::daemon {
namespace {

gpu::RgbImage ramp(int width, int height) {
    gpu::RgbImage image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int value : {x, y, 255 - x})
                image.pixels.push_back(static_cast<std::uint8_t>(value));
    return image;
}

TEST(HttpPicture, SmallPixelsAreMeansOfThoseTheyCover) {
    const gpu::RgbImage small = shrunk(ramp(200, 100), 100);
    ASSERT_EQ(small.width, 100);
    ASSERT_EQ(small.height, 50);
    for (std::size_t y = 0; y < 50; ++y)
        for (std::size_t x = 0; x < 100; ++x) { // the mean of 2x and 2x + 1, a half rounded up
            const std::size_t at = 3 * (y * 100 + x);
            ASSERT_EQ(small.pixels[at], 2 * x + 1);
            ASSERT_EQ(small.pixels[at + 1], 2 * y + 1);
            ASSERT_EQ(small.pixels[at + 2], 255 - 2 * x);
        }
}

TEST(HttpPicture, FitsWhateverItsShape) {
    for (const auto& [width, height] : {std::pair{201, 97}, {97, 201}, {3000, 1}, {1, 3000}}) {
        const gpu::RgbImage small = shrunk(ramp(width, height), 64);
        EXPECT_EQ(std::max(small.width, small.height), 64);
        EXPECT_EQ(small.pixels.size(), 3 * static_cast<std::size_t>(small.width) *
                                           static_cast<std::size_t>(small.height));
    }
    EXPECT_EQ(shrunk(ramp(20, 10), 64).width, 20) << "never larger";
}

TEST(HttpPicture, AnAnswerWithoutOneIsAnError) {
    const auto bytes = std::make_shared<const std::vector<std::uint8_t>>(12, std::uint8_t{0});
    EXPECT_EQ(pictureIn({R"({"width":2,"height":2})", bytes}).width, 2);
    for (const char* line : {"", "[]", R"({"width":2,"height":3})", R"({"width":-2,"height":-2})"})
        EXPECT_THROW((void)pictureIn({line, bytes}), std::runtime_error) << line;
    EXPECT_THROW((void)pictureIn({R"({"width":2,"height":2})"}), std::runtime_error);
}

} // namespace
} // namespace autostereo::daemon

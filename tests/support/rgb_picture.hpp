#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace autostereo::test {

/// 8 bits of R, G, B a pixel, top row first.
struct RgbPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

/// A PNG or JPEG. Throws std::runtime_error.
[[nodiscard]] RgbPicture readPicture(const std::filesystem::path& file);
/// The same brought to that size. Throws std::runtime_error.
[[nodiscard]] RgbPicture readBackdrop(const std::filesystem::path& file, int width, int height);
/// Between four pixels, bilinear; pixel centres are at integers, beyond the edge is the edge.
[[nodiscard]] glm::dvec3 texelOf(const RgbPicture& picture, const glm::dvec2& at);

} // namespace autostereo::test

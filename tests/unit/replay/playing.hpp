#pragma once

#include "devices/replay/image_files.hpp"
#include "devices/source.hpp"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <vector>

namespace autostereo::test {

/// A whole picture file in memory.
struct LoadedImage {
    devices::ImageHeader header;
    std::vector<std::byte> pixels;

    [[nodiscard]] std::vector<std::uint16_t> counts() const {
        std::vector<std::uint16_t> result(pixels.size() / 2);
        std::memcpy(result.data(), pixels.data(), pixels.size());
        return result;
    }
};

inline LoadedImage loadImage(const std::filesystem::path& path) {
    devices::ImageReader reader;
    LoadedImage image;
    image.header = reader.open(path);
    image.pixels.resize(image.header.bytes());
    reader.decode(image.pixels);
    return image;
}

/// The next frame, or nothing at the end.
inline std::optional<devices::Frame> nextFrame(devices::Source& source) {
    auto result = source.read({});
    if (auto* frame = std::get_if<devices::Frame>(&result)) return std::move(*frame);
    return std::nullopt;
}

/// Reads to the end, or until more frames came than any test's file holds.
inline int countFrames(devices::Source& source) {
    constexpr int kFarTooMany = 100'000;
    int frames = 0;
    while (frames < kFarTooMany && nextFrame(source))
        ++frames;
    return frames;
}

} // namespace autostereo::test

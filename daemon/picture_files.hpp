#pragma once

#include "gpu/exports.hpp"
#include "gpu/readback.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace autostereo::daemon {

/// Pictures of the GPU room as PNG and TIFF files. Throw std::runtime_error.
void writePicturePng(const std::filesystem::path& file, const gpu::RgbImage& image);
void writeFloatTiff(const std::filesystem::path& file, const gpu::FloatImage& image);
void writeDepthPng(const std::filesystem::path& file, const gpu::DepthImage& image);

/// R, G, B of what an ImageReader decoded as Rgba8.
[[nodiscard]] std::vector<std::uint8_t> withoutAlpha(std::span<const std::byte> rgba);

} // namespace autostereo::daemon

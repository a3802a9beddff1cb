#pragma once

#include "gpu/exports.hpp"
#include "gpu/readback.hpp"

#include <filesystem>

namespace autostereo::daemon {

/// Pictures of the GPU room as PNG and TIFF files. Throw std::runtime_error.
void writePicturePng(const std::filesystem::path& file, const gpu::RgbImage& image);
void writeFloatTiff(const std::filesystem::path& file, const gpu::FloatImage& image);
void writeDepthPng(const std::filesystem::path& file, const gpu::DepthImage& image);

} // namespace autostereo::daemon

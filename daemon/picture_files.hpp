#pragma once

#include "gpu/exports.hpp"
#include "gpu/readback.hpp"

#include <filesystem>

namespace autostereo::daemon {

/// Pictures of the GPU room as PNG files. Throw std::runtime_error.
void writePicturePng(const std::filesystem::path& file, const gpu::RgbImage& image);
void writeDepthPng(const std::filesystem::path& file, const gpu::DepthImage& image);

} // namespace autostereo::daemon

#include "devices/v4l2/unpack.hpp"

#include <algorithm>

namespace autostereo::devices::v4l2 {

namespace {

/// Rows as they lie in the buffer: NV12's chroma follows its luma in rows of the same length.
std::size_t rowsOf(PixelFormat format, int height) {
    const auto rows = static_cast<std::size_t>(height);
    return format == PixelFormat::Nv12 ? rows + rows / 2 : rows;
}

std::size_t rowBytes(PixelFormat format, int width, int height) {
    return frameBytes(format, width, height) / rowsOf(format, height);
}

} // namespace

std::size_t bufferBytes(PixelFormat format, int width, int height, std::size_t stride) {
    constexpr std::size_t kMostStride = std::size_t{1} << 20U;
    if (!allowsSize(format, width, height)) return 0;
    const std::size_t row = rowBytes(format, width, height);
    if (stride < row || stride > kMostStride) return 0;
    return stride * (rowsOf(format, height) - 1) + row;
}

bool unpack(std::span<const std::byte> buffer, std::size_t stride, Frame& frame) {
    const FrameMetadata& shape = frame.metadata();
    const std::size_t needed = bufferBytes(shape.format, shape.width, shape.height, stride);
    if (needed == 0 || buffer.size() < needed) return false;
    const std::size_t row = rowBytes(shape.format, shape.width, shape.height);
    const std::span<std::byte> pixels = frame.pixels();
    if (stride == row) {
        std::ranges::copy(buffer.first(pixels.size()), pixels.begin());
        return true;
    }
    for (std::size_t y = 0; y < rowsOf(shape.format, shape.height); ++y)
        std::ranges::copy(buffer.subspan(y * stride, row), pixels.subspan(y * row).begin());
    return true;
}

} // namespace autostereo::devices::v4l2

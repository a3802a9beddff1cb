#include "gpu/color_converter.hpp"

#include "gpu/gl/dispatch.hpp"

#include <string>

namespace autostereo::gpu {

namespace {

using devices::PixelFormat;

/// The shader's variant; empty where there is nothing to convert.
std::string variantOf(PixelFormat format) {
    switch (format) {
    case PixelFormat::Yuyv:
        return "YUYV";
    case PixelFormat::Uyvy:
        return "UYVY";
    case PixelFormat::Nv12:
        return "NV12";
    case PixelFormat::Grey8:
        return "GREY";
    case PixelFormat::Rgb8:
        return "RGB";
    case PixelFormat::Bgr8:
        return "BGR";
    case PixelFormat::Depth16:
    case PixelFormat::Rgba8:
    case PixelFormat::Bgra8:
        break;
    }
    return "";
}

} // namespace

ColorBlock colorBlock(const devices::FrameMetadata& frame) {
    constexpr int kHdRows = 720;
    const bool hd = frame.matrix == devices::YuvMatrix::Auto
                        ? frame.height >= kHdRows
                        : frame.matrix == devices::YuvMatrix::Bt709;
    const double red = hd ? 0.2126 : 0.299, blue = hd ? 0.0722 : 0.114;
    const double green = 1 - red - blue;
    const double cr = 2 * (1 - red), cb = 2 * (1 - blue);
    const bool full = frame.range == devices::YuvRange::Full;
    return {full ? glm::dvec4(0, 1, 1, 0) : glm::dvec4(16.0 / 255, 255.0 / 219, 255.0 / 224, 0),
            glm::dvec4(cr, cb, cb * blue / green, cr * red / green)};
}

bool ColorConverter::converts(PixelFormat format) { return !variantOf(format).empty(); }

bool ColorConverter::sharesChroma(PixelFormat format) {
    return format == PixelFormat::Yuyv || format == PixelFormat::Uyvy ||
           format == PixelFormat::Nv12;
}

ColorConverter::ByteGrid ColorConverter::byteGrid(const devices::FrameMetadata& frame) {
    const int rows = frame.format == PixelFormat::Nv12 ? frame.height / 2 * 3 : frame.height;
    const std::size_t bytes = devices::frameBytes(frame.format, frame.width, frame.height);
    return {static_cast<int>(bytes / static_cast<std::size_t>(rows)), rows};
}

void ColorConverter::convert(const devices::FrameMetadata& frame, GLuint bytes,
                             const gl::Texture& color, const BlockMarks* marks) {
    uniforms_.bind(6, colorBlock(frame));
    glBindTextureUnit(0, bytes);
    glBindImageTexture(0, color.name(), 0, GL_FALSE, 0,
                       marks != nullptr ? GL_READ_WRITE : GL_WRITE_ONLY, GL_RGBA8);
    if (marks != nullptr) marks->bind(1);
    gl::dispatch(program(frame.format, marks != nullptr), color.width(), color.height());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

const gl::Program& ColorConverter::program(PixelFormat format, bool marks) {
    const auto found = programs_.find({format, marks});
    if (found != programs_.end()) return found->second;
    const std::vector<std::string> shaders{"color_converter.comp"};
    std::vector<std::string> defines{variantOf(format)};
    if (marks) defines.emplace_back("MARKS");
    return programs_.emplace(std::pair(format, marks), gl::Program(shaders, defines)).first->second;
}

} // namespace autostereo::gpu

#include "daemon/preview.hpp"

#include "gpu/exports.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace autostereo::daemon {

namespace {

constexpr int kSide = 640;      // pixels, the longer side of what is drawn
constexpr int kDepthSide = 480; // its texels come back one by one

struct Size {
    int width, height;
};

/// The panel's form in so many pixels.
Size fitted(int width, int height, int side) {
    const double scale = std::min(1.0, static_cast<double>(side) / std::max(width, height));
    const auto scaled = [&](int pixels) {
        return std::max(1, static_cast<int>(std::lround(pixels * scale)));
    };
    return {scaled(width), scaled(height)};
}

gpu::RgbImage colorOf(const gpu::gl::Texture& color) {
    gpu::RgbImage image{color.width(), color.height(), {}};
    image.pixels.resize(3 * static_cast<std::size_t>(image.width) *
                        static_cast<std::size_t>(image.height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(color.name(), 0, GL_RGB, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(image.pixels.size()), image.pixels.data());
    return image;
}

/// 0 (as far as the display can show) to 1 -> night, sea, sand.
std::array<std::uint8_t, 3> shadeOf(float share) {
    constexpr std::array<std::array<float, 3>, 4> kStops{
        {{18, 20, 38}, {36, 84, 122}, {92, 176, 158}, {250, 226, 160}}};
    const float place = std::clamp(share, 0.0F, 1.0F) * (kStops.size() - 1);
    const auto stop = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    std::array<std::uint8_t, 3> shade{};
    for (std::size_t c = 0; c < shade.size(); ++c)
        shade[c] = static_cast<std::uint8_t>(std::lround(
            std::lerp(kStops[stop][c], kStops[stop + 1][c], place - static_cast<float>(stop))));
    return shade;
}

gpu::RgbImage depthOf(const gpu::FloatImage& disparity, const calib::DisplayProfile& display) {
    gpu::RgbImage image{disparity.width, disparity.height, {}};
    image.pixels.reserve(3 * disparity.values.size());
    const auto far = static_cast<float>(display.disparityFar);
    const auto range = static_cast<float>(display.disparityNear - display.disparityFar);
    for (const float value : disparity.values) {
        const auto shade = shadeOf((value - far) / range);
        image.pixels.insert(image.pixels.end(), shade.begin(), shade.end());
    }
    return image;
}

} // namespace

gpu::RgbImage previewOf(const PreviewRequest& request, const gpu::Pipeline& pipeline,
                        const gpu::PipelineParams& params, const calib::DisplayProfile& display,
                        int panelWidth, int panelHeight) {
    if (request.of == PreviewRequest::Of::Color) return colorOf(pipeline.color());
    if (request.of == PreviewRequest::Of::Depth) {
        const Size size = fitted(panelWidth, panelHeight, kDepthSide);
        return depthOf(gpu::renderDisparity(pipeline, params, display, size.width, size.height),
                       display);
    }
    const Size size = fitted(panelWidth, panelHeight, kSide);
    const double distance = display.viewingDistanceM;
    const double x = request.eye * distance * std::tan(display.coneRad / 2);
    return gpu::renderEye(pipeline, params, display, {x, 0, distance}, size.width, size.height);
}

} // namespace autostereo::daemon

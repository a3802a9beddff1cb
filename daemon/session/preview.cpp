#include "daemon/session/preview.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace autostereo::daemon {

namespace {

constexpr int kSide = 480;      // pixels, the longer side of what is drawn
constexpr int kTexels = 40'000; // of the scene: what is seen of it at that size

struct Size {
    int width, height;
};

/// The panel's form in so many pixels.
Size fitted(int width, int height) {
    const double scale = std::min(1.0, static_cast<double>(kSide) / std::max(width, height));
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

} // namespace

Preview::Preview(const gpu::PipelineParams& params, const calib::DisplayProfile& display,
                 int panelWidth, int panelHeight)
    : clearColor_(params.clearColor), display_(display), coarse_(kTexels), drawer_(params.mesh),
      program_({"mesh_eye.vert", "mesh_view.frag"}),
      color_(GL_RGBA8, fitted(panelWidth, panelHeight).width,
             fitted(panelWidth, panelHeight).height),
      depth_(GL_DEPTH_COMPONENT32F, color_.width(), color_.height()),
      target_(gpu::gl::makeFramebuffer(color_, &depth_)),
      disparity_(params.mesh, color_.width(), color_.height(), display.disparityFar) {}

gpu::RgbImage Preview::draw(const PreviewRequest& request, const gpu::Pipeline& pipeline) {
    if (request.of == PreviewRequest::Of::Color) return colorOf(pipeline.color());
    const gpu::CyclopeanScene scene = coarse_.of(pipeline.scene());
    gpu::MeshBlock block = pipeline.mesh().block();
    block.grid.x = static_cast<float>(scene.depth.width());
    block.grid.y = static_cast<float>(scene.depth.height());
    mesh_.bind(0, block);
    const gpu::MeshLayers& layers = mesher_.build(scene);
    return request.of == PreviewRequest::Of::Depth ? drawDepth(layers, pipeline)
                                                   : drawEye(layers, pipeline, request.eye);
}

gpu::RgbImage Preview::drawDepth(const gpu::MeshLayers& layers, const gpu::Pipeline& pipeline) {
    disparity_.render(layers, pipeline.color());
    gpu::RgbImage image{color_.width(), color_.height(), {}};
    std::vector<float> values(static_cast<std::size_t>(image.width) *
                              static_cast<std::size_t>(image.height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(disparity_.texture().name(), 0, GL_RED, GL_FLOAT,
                      static_cast<GLsizei>(values.size() * sizeof(float)), values.data());
    gpu::flipRows(values, static_cast<std::size_t>(image.width));
    image.pixels.reserve(3 * values.size());
    const auto far = static_cast<float>(display_.disparityFar);
    const auto range = static_cast<float>(display_.disparityNear) - far;
    for (const float value : values) {
        const auto shade = shadeOf((value - far) / range);
        image.pixels.insert(image.pixels.end(), shade.begin(), shade.end());
    }
    return image;
}

gpu::RgbImage Preview::drawEye(const gpu::MeshLayers& layers, const gpu::Pipeline& pipeline,
                               double place) {
    const double distance = display_.viewingDistanceM;
    const double x = place * distance * std::tan(display_.coneRad / 2);
    eye_.bind(3, gpu::eyeBlock(display_, {x, 0, distance},
                               static_cast<double>(color_.height()) / color_.width()));
    gpu::LayerDrawer::clear(target_.name(), clearColor_);
    glViewport(0, 0, color_.width(), color_.height());
    program_.use();
    drawer_.draw(layers, pipeline.color(), {1, 1, 0, 0}, 1);
    return gpu::readFramebuffer(target_.name(), color_.width(), color_.height());
}

} // namespace autostereo::daemon

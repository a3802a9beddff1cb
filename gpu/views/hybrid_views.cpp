#include "gpu/views/hybrid_views.hpp"

#include "calib/view_map.hpp"
#include "gpu/views/view_synthesis.hpp"

#include <array>
#include <vector>

namespace autostereo::gpu {

namespace {

gl::Texture positionsOf(const std::vector<float>& positions) {
    const auto count = static_cast<int>(positions.size());
    gl::Texture texture(GL_R32F, count, 1);
    glTextureSubImage2D(texture.name(), 0, 0, 0, count, 1, GL_RED, GL_FLOAT, positions.data());
    return texture;
}

} // namespace

HybridViews::HybridViews(const calib::DisplayProfile& display, const PipelineParams& params,
                         int references)
    : params_(params), farthest_(display.disparityFar), references_(references),
      drawer_(params.mesh), draw_({"mesh_view.vert", "mesh_reference.frag"}, {"DISPARITY"}),
      reproject_({"full_screen.vert", "hybrid_views.frag"}), positions_(makeViewPositions(display)),
      vertexArray_(gl::makeVertexArray()) {
    // From the outermost view to the other.
    const double first = calib::viewPosition(display, 0);
    const double last = calib::viewPosition(display, display.views - 1);
    const double step = (last - first) / (references - 1);
    std::vector<float> places;
    places.reserve(static_cast<std::size_t>(references));
    for (int i = 0; i < references; ++i)
        places.push_back(static_cast<float>(first + i * step));
    referencePositions_ = positionsOf(places);
    block_.references = {first, step != 0 ? step : 1.0, 0, 0};
}

void HybridViews::render(const MeshLayers& layers, const gl::Texture& color, const Atlas& atlas) {
    const calib::QuiltLayout& quilt = atlas.layout().quilt;
    if (!colors_.isSized(references_ * quilt.tileWidth, quilt.tileHeight)) resize(quilt);
    drawReferences(layers, color);

    block_.tiles = {quilt.columns, quilt.tileWidth, quilt.tileHeight, references_};
    // Neighbouring pixels of one surface differ less: two pixels apart in the outermost view.
    block_.references.z = 2.0F / static_cast<float>(quilt.tileWidth);
    uniforms_.bind(3, block_);
    LayerDrawer::clear(atlas.framebuffer(), params_.clearColor);
    glViewport(0, 0, atlas.layout().width(), atlas.layout().height());
    reproject_.use();
    glBindTextureUnit(0, colors_.name());
    glBindTextureUnit(1, disparities_.name());
    glBindTextureUnit(3, positions_.name());
    glBindVertexArray(vertexArray_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void HybridViews::drawReferences(const MeshLayers& layers, const gl::Texture& color) {
    const std::array<float, 4> farthest{static_cast<float>(farthest_), 0, 0, 0};
    const int width = colors_.width() / references_;
    LayerDrawer::clear(framebuffer_.name(), params_.clearColor);
    glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 1, farthest.data());
    draw_.use();
    glBindTextureUnit(3, referencePositions_.name());
    for (int reference = 0; reference < references_; ++reference) {
        glViewport(reference * width, 0, width, colors_.height());
        drawer_.draw(layers, color, {1, 1, reference, 0}, 1);
    }
}

void HybridViews::resize(const calib::QuiltLayout& tiles) {
    const int width = references_ * tiles.tileWidth, height = tiles.tileHeight;
    constexpr std::array<GLenum, 2> kTargets{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    colors_ = gl::Texture(GL_RGBA8, width, height);
    colors_.setFilter(GL_LINEAR);
    disparities_ = gl::Texture(GL_R32F, width, height);
    depth_ = gl::Texture(GL_DEPTH_COMPONENT32F, width, height);
    framebuffer_ = gl::makeFramebuffer(colors_, &depth_);
    glNamedFramebufferTexture(framebuffer_.name(), kTargets[1], disparities_.name(), 0);
    glNamedFramebufferDrawBuffers(framebuffer_.name(), 2, kTargets.data());
}

} // namespace autostereo::gpu

#include "gpu/scene/line_screen_views.hpp"

#include "calib/band_map.hpp"
#include "gpu/layer_drawer.hpp"
#include "gpu/scene/scene_views.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::gpu {

namespace {

constexpr float kNearest = 0, kFarthest = 1;

void clearDepth(GLuint framebuffer, float depth) {
    glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &depth);
}

void writeColors(bool red, bool green, bool blue) {
    const auto flag = [](bool on) { return static_cast<GLboolean>(on ? GL_TRUE : GL_FALSE); };
    glColorMask(flag(red), flag(green), flag(blue), GL_TRUE);
}
void writeColor(std::size_t color) { writeColors(color == 0, color == 1, color == 2); }
void writeDepthOnly() { glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); }

} // namespace

LineScreenViews::LineScreenViews(const calib::DisplayProfile& display, SceneShading shading,
                                 LineScreenMethod method, const calib::EyePair& eyes)
    : method_(method), width_(display.width), height_(display.height),
      scene_({"scene_view.vert", "scene_view.frag"}, definesOf(shading)),
      screen_({"line_screen.vert", "line_screen.frag"}), eyes_(makeEyes({eyes.left, eyes.right})),
      vertexArray_(gl::makeVertexArray()) {
    for (std::size_t eye = 0; eye < kEyes; ++eye) {
        const glm::dvec3& place = eye == 0 ? eyes.left : eyes.right;
        const auto offsets = std::get<calib::LineScreen>(display.law).subpixelOffsetsM;
        const auto [least, most] = std::ranges::minmax(offsets);
        middles_.at(eye) = linesOf(display, place, 0, 0);
        whole_.at(eye) = linesOf(display, place, least, most);
        for (std::size_t c = 0; c < kColors; ++c)
            colors_.at(eye).at(c) = linesOf(display, place, offsets.at(c), offsets.at(c));
    }
}

/// Of what is hidden `leastOffset` to `mostOffset` metres beside a pixel's middle. A place is lit
/// where its phase, less whole cycles, is from c + guard/2 to 1 - guard/2 (calib::LineScreen).
LineScreenViews::Lines LineScreenViews::linesOf(const calib::DisplayProfile& display,
                                                const glm::dvec3& eye, double leastOffset,
                                                double mostOffset) {
    const auto& screen = std::get<calib::LineScreen>(display.law);
    const calib::LinearPhase phase =
        calib::lineScreenPhase(screen, display, display.width, display.height, eye);
    const double perM = phase.perColumn * display.width / display.widthM;
    const double from = -screen.guard / 2 - perM * leastOffset;
    const double to = screen.dutyCycle + screen.guard / 2 - perM * mostOffset;
    const double atLeft = phase.offset - 0.5 * phase.perColumn,
                 atRight = atLeft + phase.perColumn * display.width;
    const double above = -0.5 * phase.perRow, below = above + phase.perRow * display.height;
    const double first = std::floor(atLeft + std::min(above, below) - to);
    const double last = std::ceil(atRight + std::max(above, below) - from);
    const double perCycle = 2 / (phase.perColumn * display.width); // of clip x
    const auto edgeAt = [&](double row) { return perCycle * (first + from - atLeft - row) - 1; };
    return {
        {glm::dvec4(edgeAt(below), edgeAt(above), perCycle, perCycle * (to - from)), glm::vec4(0)},
        static_cast<GLsizei>(last - first) + 1};
}

void LineScreenViews::render(const SceneModel& model, const SceneBlock& block, GLuint framebuffer) {
    framebuffer_ = framebuffer;
    block_ = block;
    LayerDrawer::clear(framebuffer, {0, 0, 0});
    glViewport(0, 0, width_, height_);
    glBindTextureUnit(2, eyes_.name());
    const DepthTest depthTest;
    switch (method_) {
    case LineScreenMethod::OneOne:
        oneOne(model);
        break;
    case LineScreenMethod::ThreeThree:
        threeThree(model);
        break;
    case LineScreenMethod::FourOne:
        fourOne(model);
        break;
    }
    writeColors(true, true, true);
}

void LineScreenViews::drawLines(Lines lines, float depth) {
    lines.block.depth.x = depth;
    screenUniforms_.bind(6, lines.block);
    screen_.use();
    glBindVertexArray(vertexArray_.name());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, lines.count);
}

void LineScreenViews::drawScene(const SceneModel& model, std::size_t eye) {
    block_.viewTiles = {1, 1, static_cast<int>(eye), static_cast<int>(kEyes)};
    sceneUniforms_.bind(7, block_);
    scene_.use();
    model.draw(1);
}

void LineScreenViews::oneOne(const SceneModel& model) {
    for (std::size_t eye = 0; eye < kEyes; ++eye) {
        clearDepth(framebuffer_, kFarthest);
        writeDepthOnly();
        drawLines(middles_.at(eye), kNearest);
        writeColors(true, true, true);
        drawScene(model, eye);
    }
}

/// The paper's list clears depth once an eye; what one colour hides would then stay hidden in the
/// next. It says itself that this is 1/1 three times, which clears it each time.
void LineScreenViews::threeThree(const SceneModel& model) {
    for (std::size_t eye = 0; eye < kEyes; ++eye)
        for (std::size_t c = 0; c < kColors; ++c) {
            clearDepth(framebuffer_, kFarthest);
            writeDepthOnly();
            drawLines(colors_.at(eye).at(c), kNearest);
            writeColor(c);
            drawScene(model, eye);
        }
}

/// The paper says which passes there are, not their states; these are the ones that make its
/// picture: "selectively clearing" is black lines and a depth buffer that is near everywhere but
/// behind lines. After the right eye's scene no depth is needed any more, so its fourth is left
/// out.
void LineScreenViews::fourOne(const SceneModel& model) {
    drawScene(model, 0);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_ALWAYS);
    blacken(0);
    glDepthMask(GL_TRUE);
    writeDepthOnly();
    clearDepth(framebuffer_, kNearest);
    drawLines(whole_[0], kFarthest);
    glDepthFunc(GL_LESS);
    writeColors(true, true, true);
    drawScene(model, 1);
    glDepthMask(GL_FALSE);
    blacken(1); // but what is kept near
    glDepthMask(GL_TRUE);
}

void LineScreenViews::blacken(std::size_t eye) {
    for (std::size_t c = 0; c < kColors; ++c) {
        writeColor(c);
        drawLines(colors_.at(eye).at(c), kNearest);
    }
}

} // namespace autostereo::gpu

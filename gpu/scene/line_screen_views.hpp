#pragma once

#include "calib/display_profile.hpp"
#include "calib/eye_pair.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/gl/uniform_buffer.hpp"
#include "gpu/scene/scene_block.hpp"
#include "gpu/scene/scene_model.hpp"

#include <array>

namespace autostereo::gpu {

/// How often line screen and scene are drawn for each eye (Kooima 2007, section 2.3).
/// OneOne: once; whole pixels are an eye's or not, by their middle.
/// ThreeThree: once for each colour, whose sub-pixels the line screen is shifted to.
/// FourOne: the scene once; line screens of each colour blacken what an eye does not see, and one
/// keeps the right eye's scene off the pixels that show the left eye any of their colours. A pixel
/// is of one eye therefore: with bands that share pixels the right one's loses what they share.
enum class LineScreenMethod { OneOne, ThreeThree, FourOne };

/// shaders/line_screen.vert, binding 6.
struct LineScreenBlock {
    glm::vec4 edges{0};
    glm::vec4 depth{0};
};
static_assert(sizeof(LineScreenBlock) == 32);

/// A scene of triangles on the panel of a tracked barrier by the algorithms that came before the
/// Combiner: views go straight to the panel, before black, and the depth buffer keeps from it what
/// the barrier hides. They are what the Combiner (BandInterleaver) is measured against. Where both
/// eyes' bands overlap, the right eye's view is shown (the left one's with FourOne). Phase grids
/// are not known to straight lines. Thread-bound.
class LineScreenViews {
  public:
    /// `display` has a line screen; eyes are in front of it. Throws GlError.
    LineScreenViews(const calib::DisplayProfile& display, SceneShading shading,
                    LineScreenMethod method, const calib::EyePair& eyes);

    /// `block`: of the scene as `model` is placed. The target has the display's size, and depth.
    void render(const SceneModel& model, const SceneBlock& block, GLuint framebuffer);

  private:
    /// Lines of the panel, behind which a sub-pixel is hidden from an eye.
    struct Lines {
        LineScreenBlock block;
        GLsizei count = 0;
    };
    static constexpr std::size_t kEyes = 2, kColors = 3;

    [[nodiscard]] static Lines linesOf(const calib::DisplayProfile& display, const glm::dvec3& eye,
                                       double leastOffset, double mostOffset);
    void drawLines(Lines lines, float depth);
    void drawScene(const SceneModel& model, std::size_t eye);
    void oneOne(const SceneModel& model);
    void threeThree(const SceneModel& model);
    void fourOne(const SceneModel& model);
    void blacken(std::size_t eye);

    LineScreenMethod method_;
    int width_, height_;
    gl::Program scene_, screen_;
    gl::Texture eyes_;
    gl::VertexArray vertexArray_;
    SceneBlock block_;
    gl::UniformBuffer<SceneBlock> sceneUniforms_;
    gl::UniformBuffer<LineScreenBlock> screenUniforms_;
    /// Of pixels' middles, of each colour, and of what hides all three.
    std::array<Lines, kEyes> middles_, whole_;
    std::array<std::array<Lines, kColors>, kEyes> colors_;
    GLuint framebuffer_ = 0;
};

} // namespace autostereo::gpu

// The C++ structs of uniform blocks lie in memory as the driver lays out the shaders' blocks.

#include "gpu/blocks.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/scene/line_screen_views.hpp"
#include "gpu/scene/scene_block.hpp"
#include "gpu/scene/scene_surfaces.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cstddef>

namespace autostereo::test {
namespace {

GLint offsetOf(const gpu::gl::Program& program, const char* member) {
    const GLuint index = glGetProgramResourceIndex(program.name(), GL_UNIFORM, member);
    if (index == GL_INVALID_INDEX) return -1;
    const GLenum property = GL_OFFSET;
    GLint offset = -1;
    glGetProgramResourceiv(program.name(), GL_UNIFORM, index, 1, &property, 1, nullptr, &offset);
    return offset;
}

class BlocksGlTest : public GlTest {};

TEST_F(BlocksGlTest, MeshBlock) {
    const gpu::gl::Program program({"mesh_points.comp"});
    EXPECT_EQ(offsetOf(program, "colorFromDepth"), offsetof(gpu::MeshBlock, colorFromDepth));
    EXPECT_EQ(offsetOf(program, "colorPinhole"), offsetof(gpu::MeshBlock, colorPinhole));
    EXPECT_EQ(offsetOf(program, "colorSize"), offsetof(gpu::MeshBlock, colorSize));
    EXPECT_EQ(offsetOf(program, "colorRadial"), offsetof(gpu::MeshBlock, colorRadial));
    EXPECT_EQ(offsetOf(program, "colorRational"), offsetof(gpu::MeshBlock, colorRational));
    EXPECT_EQ(offsetOf(program, "framing"), offsetof(gpu::MeshBlock, framing));
    EXPECT_EQ(offsetOf(program, "upright"), offsetof(gpu::MeshBlock, upright));
    EXPECT_EQ(offsetOf(program, "grid"), offsetof(gpu::MeshBlock, grid));
    EXPECT_EQ(offsetOf(program, "law"), offsetof(gpu::MeshBlock, law));
    EXPECT_EQ(offsetOf(program, "budget"), offsetof(gpu::MeshBlock, budget));
    EXPECT_EQ(offsetOf(program, "counts"), offsetof(gpu::MeshBlock, counts));
}

TEST_F(BlocksGlTest, ConditionBlock) {
    const gpu::gl::Program program({"condition_measure.comp"});
    EXPECT_EQ(offsetOf(program, "valid"), offsetof(gpu::ConditionBlock, valid));
    EXPECT_EQ(offsetOf(program, "surface"), offsetof(gpu::ConditionBlock, surface));
    EXPECT_EQ(offsetOf(program, "hold"), offsetof(gpu::ConditionBlock, hold));
}

TEST_F(BlocksGlTest, SceneBlock) {
    const gpu::gl::Program program({"scene_view.vert", "scene_view.frag"}, {"PER_PIXEL"});
    EXPECT_EQ(offsetOf(program, "viewTiles"), offsetof(gpu::SceneBlock, viewTiles));
    EXPECT_EQ(offsetOf(program, "form"), offsetof(gpu::SceneBlock, form));
    EXPECT_EQ(offsetOf(program, "range"), offsetof(gpu::SceneBlock, range));
    EXPECT_EQ(offsetOf(program, "ambient"), offsetof(gpu::SceneBlock, ambient));
    EXPECT_EQ(offsetOf(program, "lightPlaces[0]"), offsetof(gpu::SceneBlock, lightPlaces));
    EXPECT_EQ(offsetOf(program, "lightColors[0]"), offsetof(gpu::SceneBlock, lightColors));
    EXPECT_EQ(offsetOf(program, "lightCones[0]"), offsetof(gpu::SceneBlock, lightCones));
    EXPECT_EQ(offsetOf(program, "lightFades[0]"), offsetof(gpu::SceneBlock, lightFades));
}

TEST_F(BlocksGlTest, SurfacesBlock) {
    const gpu::gl::Program program({"full_screen.vert", "scene_resolve.frag"}, {"PER_PIXEL"});
    EXPECT_EQ(offsetOf(program, "lattice"), offsetof(gpu::SurfacesBlock, lattice));
    EXPECT_EQ(offsetOf(program, "lineup"), offsetof(gpu::SurfacesBlock, lineup));
    EXPECT_EQ(offsetOf(program, "span"), offsetof(gpu::SurfacesBlock, span));
    EXPECT_EQ(offsetOf(program, "backdrop"), offsetof(gpu::SurfacesBlock, backdrop));
}

TEST_F(BlocksGlTest, LineScreenBlock) {
    const gpu::gl::Program program({"line_screen.vert", "line_screen.frag"});
    EXPECT_EQ(offsetOf(program, "edges"), offsetof(gpu::LineScreenBlock, edges));
    EXPECT_EQ(offsetOf(program, "depth"), offsetof(gpu::LineScreenBlock, depth));
}

TEST_F(BlocksGlTest, ColorBlock) {
    const gpu::gl::Program program({"color_converter.comp"}, {"NV12"});
    EXPECT_EQ(offsetOf(program, "levels"), offsetof(gpu::ColorBlock, levels));
    EXPECT_EQ(offsetOf(program, "weights"), offsetof(gpu::ColorBlock, weights));
}

TEST_F(BlocksGlTest, ViewsBlock) {
    const gpu::gl::Program program({"mesh_view.vert", "mesh_view.frag"});
    EXPECT_EQ(offsetOf(program, "tiles"), offsetof(gpu::ViewsBlock, tiles));
    EXPECT_EQ(offsetOf(program, "range"), offsetof(gpu::ViewsBlock, range));
}

TEST_F(BlocksGlTest, InterleaverBlock) {
    const gpu::gl::Program program({"full_screen.vert", "view_interleaver.frag"});
    EXPECT_EQ(offsetOf(program, "fan"), offsetof(gpu::InterleaverBlock, fan));
    EXPECT_EQ(offsetOf(program, "tiles"), offsetof(gpu::InterleaverBlock, tiles));
    EXPECT_EQ(offsetOf(program, "panel"), offsetof(gpu::InterleaverBlock, panel));
    EXPECT_EQ(offsetOf(program, "edge"), offsetof(gpu::InterleaverBlock, edge));
    EXPECT_EQ(offsetOf(program, "scale"), offsetof(gpu::InterleaverBlock, scale));
    EXPECT_EQ(offsetOf(program, "fine"), offsetof(gpu::InterleaverBlock, fine));
    EXPECT_EQ(offsetOf(program, "rig"), offsetof(gpu::InterleaverBlock, rig));
    EXPECT_EQ(offsetOf(program, "atlasRow"), offsetof(gpu::InterleaverBlock, atlasRow));
}

TEST_F(BlocksGlTest, PhaseBlock) {
    const gpu::gl::Program view({"full_screen.vert", "view_interleaver.frag"});
    EXPECT_EQ(offsetOf(view, "phaseSteps[0]"), offsetof(gpu::PhaseBlock<1>, phaseSteps));
    EXPECT_EQ(offsetOf(view, "channels[0]"), offsetof(gpu::PhaseBlock<1>, channels));
    const gpu::gl::Program bands({"full_screen.vert", "band_interleaver.frag"});
    EXPECT_EQ(offsetOf(bands, "phaseSteps[0]"), offsetof(gpu::PhaseBlock<16>, phaseSteps));
    EXPECT_EQ(offsetOf(bands, "channels[0]"), offsetof(gpu::PhaseBlock<16>, channels));
}

TEST_F(BlocksGlTest, EyeBlock) {
    const gpu::gl::Program eye({"mesh_eye.vert", "mesh_view.frag"});
    EXPECT_EQ(offsetOf(eye, "eye"), offsetof(gpu::EyeBlock, eye));
    EXPECT_EQ(offsetOf(eye, "form"), offsetof(gpu::EyeBlock, form));
    const gpu::gl::Program camera({"mesh_camera.vert", "mesh_view.frag"});
    EXPECT_EQ(offsetOf(camera, "offset"), offsetof(gpu::EyeBlock, eye));
}

TEST_F(BlocksGlTest, ListBlock) {
    const gpu::gl::Program program({"list_blocks.comp"});
    EXPECT_EQ(offsetOf(program, "reach[0]"), offsetof(gpu::ListBlock, reach));
    EXPECT_EQ(offsetOf(program, "size"), offsetof(gpu::ListBlock, size));
}

} // namespace
} // namespace autostereo::test

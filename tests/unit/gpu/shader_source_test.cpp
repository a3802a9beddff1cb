#include "gpu/gl/error.hpp"
#include "gpu/gl/shader_source.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace autostereo::gpu::gl {
namespace {

std::string fileText(const std::string& name) {
    std::ifstream in(test::sourceDir() / "gpu/shaders" / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << "no " << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(ShaderSource, IsTheFileWithItsIncludesInPlace) {
    EXPECT_EQ(shaderSource("full_screen.vert", {}), fileText("full_screen.vert"));
    std::string expected = fileText("mesh_camera.vert");
    for (const char* name : {"mesh_block.glsl", "camera.glsl", "views_block.glsl"})
        expected = replaced(expected, std::string("#include \"") + name + '"', fileText(name));
    EXPECT_EQ(shaderSource("mesh_camera.vert", {}), expected);
}

TEST(ShaderSource, DefinesStandBehindTheVersion) {
    const std::string plain = shaderSource("mesh_view.vert", {});
    const std::string version = "#version 450 core\n";
    ASSERT_EQ(plain.rfind(version, 0), 0U);
    EXPECT_EQ(shaderSource("mesh_view.vert", {"TILED", "SIZE 8"}),
              version + "#define TILED\n#define SIZE 8\n" + plain.substr(version.size()));
}

TEST(ShaderSource, RefusesANameItDoesNotHave) {
    try {
        (void)shaderSource("no_such.frag", {});
        FAIL() << "no error";
    } catch (const GlError& error) {
        EXPECT_STREQ(error.what(), "gl: no shader named no_such.frag");
    }
    EXPECT_THROW((void)shaderSource("", {}), GlError);
    EXPECT_THROW((void)shaderSource("shaders/full_screen.vert", {}), GlError);
}

} // namespace
} // namespace autostereo::gpu::gl

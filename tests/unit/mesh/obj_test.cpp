// Wavefront OBJ and MTL: what is read, what is repaired, what is refused.

#include "devices/replay/image_files.hpp"
#include "tests/support/data.hpp"
#include "tests/unit/mesh/mesh_files.hpp"

#include <glm/geometric.hpp>

#include <cmath>

namespace autostereo::test {
namespace {

using devices::mesh::kNone;
using devices::mesh::MeshScene;
using devices::mesh::openMesh;

class ObjTest : public testing::Test {
  protected:
    MeshScene read(const std::string& text) { return openMesh(scratch.write("scene.obj", text)); }
    std::string refused(const std::string& text) {
        return refusal(scratch.write("scene.obj", text));
    }
    void writeTexture(const std::string& name) const {
        const std::vector<std::byte> pixels(2 * 2 * 4, std::byte{200});
        devices::writePng(scratch / name, {{devices::ImageFormat::Rgba8, 2, 2}, pixels});
    }
    ScratchFolder scratch;
};

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(ObjTest, PolygonsBecomeFansWithTheirNumbersInEitherDirection) {
    const MeshScene scene = read(std::string(kSquare) + "vt 0.25 0.75\nvn 0 0 2\n" +
                                 "f 1/1/1 2/1/1 3/1/1 4/1/1\nf -4 -3 -2\nf 1//1 2//1 3//1\n");
    EXPECT_EQ(scene.triangles(), 4U);
    const auto place = [&](std::size_t index) {
        return scene.vertices[scene.indices[index]].position;
    };
    EXPECT_EQ(place(3), glm::vec3(0, 0, 0));
    EXPECT_EQ(place(4), glm::vec3(1, 1, 0));
    EXPECT_EQ(place(5), glm::vec3(0, 1, 0));
    EXPECT_EQ(place(8), glm::vec3(1, 1, 0)); // -2 of four
    EXPECT_EQ(scene.vertices[0].normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.vertices[0].uv, glm::vec2(0.25F, 0.25F)) << "v counts from the top";
}

/// Of a cube without normals every corner's points away from the middle, whatever its textures.
TEST_F(ObjTest, NormalsThatAreMissingComeFromTheFacesAround) {
    const MeshScene scene = read("v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
                                 "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nvt 0 0\nvt 1 1\n"
                                 "f 1/1 2/1 3/1 4/1\nf 6 5 8 7\nf 2/2 6/2 7/2 3/2\n"
                                 "f 5 1 4 8\nf 4 3 7 8\nf 5 6 2 1\n");
    EXPECT_EQ(scene.triangles(), 12U);
    for (const auto& vertex : scene.vertices) {
        const float along = glm::dot(vertex.normal, glm::normalize(vertex.position));
        // A corner's faces weigh one or two triangles each: up to 20 degrees off the diagonal.
        EXPECT_GT(along, 0.9F);
        EXPECT_NEAR(glm::length(vertex.normal), 1, 1e-6);
    }
    EXPECT_EQ(scene.repairs.badNormals, 0U) << "none was given, none was bad";
}

TEST_F(ObjTest, MaterialsAreAsTheirFileSays) {
    writeTexture("wood.png");
    scratch.write("scene.mtl", "newmtl red\nKd 1 0 0\nKs 0.5 0.5 0.5\nNs 40\n"
                               "newmtl wood\nmap_Kd -s 1 1 1 wood.png\n");
    const MeshScene scene = read("mtllib scene.mtl\n" + std::string(kSquare) +
                                 "usemtl red\nf 1 2 3\nusemtl wood\nf 1 3 4\nf 1 2 4\n");
    ASSERT_EQ(scene.nodes.size(), 1U);
    ASSERT_EQ(scene.nodes[0].parts.size(), 2U);
    EXPECT_EQ(scene.nodes[0].parts[1].indexCount, 6U);
    const auto& red = scene.materials[static_cast<std::size_t>(scene.nodes[0].parts[0].material)];
    EXPECT_EQ(red.diffuse, glm::vec3(1, 0, 0));
    EXPECT_NEAR(red.specular.r, 0.21404, 1e-5); // sRGB's 0.5 in light
    EXPECT_EQ(red.shininess, 40);
    const auto& wood = scene.materials[static_cast<std::size_t>(scene.nodes[0].parts[1].material)];
    ASSERT_EQ(wood.texture, 0);
    EXPECT_EQ(scene.textures[0].width, 2);
    EXPECT_EQ(scene.textures[0].rgba[0], std::byte{200});
}

TEST_F(ObjTest, WhatIsNowhereIsLeftOutAndCounted) {
    const MeshScene scene = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 1e999 0 inf\n"
                                 "vn nan 0 1\nf 1//1 2//1 3//1\nf 1 2 4\nf 1 2 5\n");
    EXPECT_EQ(scene.triangles(), 1U);
    EXPECT_EQ(scene.repairs.badTriangles, 2U);
    EXPECT_EQ(scene.repairs.badNormals, 3U);
    for (const auto& vertex : scene.vertices)
        EXPECT_TRUE(std::isfinite(vertex.position.x) && std::isfinite(vertex.normal.x));
    EXPECT_EQ(scene.repairs.why.size(), 2U);
}

TEST_F(ObjTest, TexturesOutsideOfTheFolderAreNotRead) {
    const auto inner = scratch / "inner";
    std::filesystem::create_directories(inner);
    writeTexture("secret.png");
    std::filesystem::create_symlink(scratch / "secret.png", inner / "link.png");
    for (const std::string& name :
         {std::string("../secret.png"), (scratch / "secret.png").string(), std::string("link.png"),
          std::string("x/../../secret.png"), std::string("missing.png"), std::string(".")}) {
        scratch.write("inner/scene.mtl", "newmtl m\nmap_Kd " + name + "\n");
        scratch.write("inner/scene.obj",
                      "mtllib scene.mtl\n" + std::string(kSquare) + "usemtl m\nf 1 2 3\n");
        const MeshScene scene = openMesh(inner / "scene.obj");
        EXPECT_EQ(scene.repairs.textures, 1U) << name;
        EXPECT_TRUE(scene.textures.empty()) << name;
        EXPECT_EQ(scene.materials.back().texture, kNone);
        EXPECT_EQ(scene.triangles(), 1U);
    }
}

TEST_F(ObjTest, WhatMakesNoSenseIsRefusedWithItsLine) {
    const std::string square = kSquare;
    const auto says = [&](const std::string& text, const std::string& what) {
        const std::string error = refused(text);
        EXPECT_NE(error.find(what), std::string::npos) << error;
    };
    says(square + "f 1 2 100000000\n", "scene.obj:5: f = '100000000' (allowed 1 to 4)");
    says(square + "f 1 2 99999999999999999999\n", "scene.obj:5: f = ");
    says(square + "f 0 1 2\n", "scene.obj:5: f = '0'");
    says(square + "f -5 1 2\n", "scene.obj:5: f = '-5'");
    says(square + "f 1/7 2 3\n", "scene.obj:5: f = '1/7'");
    says(square + "f 1/2/3/4 2 3\n", "scene.obj:5");
    says(square + "f 1 2\n", "three corners");
    says("v 1 2\n", "scene.obj:1: v = '' (allowed a number)");
    says("v 1 x 2\n", "scene.obj:1: v = 'x' (allowed a number)");
    says(square, "no triangles");
    says("", "no triangles");
    says(std::string(100000, '\xff'), "no triangles");
}

TEST_F(ObjTest, LimitsHoldBeforeMemoryIsAskedFor) {
    devices::mesh::MeshLimits limits;
    limits.vertices = 3;
    const auto file = scratch.write("scene.obj", std::string(kSquare) + "f 1 2 3\n");
    EXPECT_NE(refusal(file, limits).find("too many vertices (allowed 3)"), std::string::npos);
    limits = {};
    limits.indices = 3;
    scratch.write("scene.obj", std::string(kSquare) + "f 1 2 3 4\n");
    EXPECT_NE(refusal(file, limits).find("too many indices"), std::string::npos);
    limits = {};
    limits.fileBytes = 10;
    EXPECT_NE(refusal(file, limits).find("(allowed up to 10)"), std::string::npos);
}

/// Cut at every byte: refused in one line, or a scene whose numbers are all in range.
TEST_F(ObjTest, CutOffAnywhereItIsReadOrRefused) {
    const std::string whole =
        std::string(kSquare) + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1 3 4\n";
    int read = 0;
    for (std::size_t length = 0; length <= whole.size(); ++length) {
        const auto file = scratch.write("cut.obj", whole.substr(0, length));
        if (!refusal(file).empty()) continue;
        ++read;
        const MeshScene scene = openMesh(file);
        for (const std::uint32_t index : scene.indices)
            EXPECT_LT(index, scene.vertices.size());
    }
    EXPECT_GT(read, 5);
}

struct RealMesh {
    const char* file;
    std::size_t triangles;
    std::size_t textures;
};

TEST_F(ObjTest, RealMeshesAreWhole) {
    for (const RealMesh& mesh :
         {RealMesh{"meshes/suzanne.obj", 968, 0}, RealMesh{"meshes/nefertiti.obj", 99938, 0},
          RealMesh{"meshes/stanford-bunny.obj", 69451, 0},
          RealMesh{"meshes/spot/spot_triangulated.obj", 5856, 0},
          RealMesh{"meshes/crate/crate.obj", 12, 1}}) {
        AUTOSTEREO_NEED_DATA(mesh.file);
        const MeshScene scene = openMesh(dataDir() / mesh.file);
        EXPECT_EQ(scene.triangles(), mesh.triangles) << mesh.file;
        EXPECT_EQ(scene.textures.size(), mesh.textures) << mesh.file;
        EXPECT_EQ(scene.repairs.badTriangles + scene.repairs.textures, 0U) << mesh.file;
    }
}

} // namespace
} // namespace autostereo::test

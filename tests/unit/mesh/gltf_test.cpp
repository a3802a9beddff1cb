// glTF 2.0: nodes, materials, textures, animation; and what is refused.

#include "devices/mesh/gltf_materials.hpp"
#include "devices/replay/image_files.hpp"
#include "tests/support/data.hpp"
#include "tests/unit/mesh/mesh_files.hpp"

#include <cmath>
#include <fstream>
#include <numbers>

namespace autostereo::test {
namespace {

using devices::mesh::MeshScene;
using devices::mesh::openMesh;

/// Three vertices (36 bytes), three indices (6), then times 0 and 2 (8, from 44), two turns (32).
std::string chunk() {
    const float half = std::numbers::sqrt2_v<float> / 2;
    return bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + bytesOf<std::uint16_t>({0, 1, 2, 0}) +
           bytesOf<float>({0, 2}) + bytesOf<float>({0, 0, 0, 1, 0, 0, half, half});
}

const std::string kNodes = R"("scene":0,"scenes":[{"nodes":[0]}],
  "nodes":[{"name":"base","translation":[10,0,0],"children":[1]},{"name":"arm","mesh":0}])";
const std::string kMeshes =
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])";
const std::string kBuffers = R"("buffers":[{"byteLength":84}],
  "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},
                 {"buffer":0,"byteOffset":36,"byteLength":6},
                 {"buffer":0,"byteOffset":44,"byteLength":8},
                 {"buffer":0,"byteOffset":52,"byteLength":32}],
  "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
               {"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"},
               {"bufferView":2,"componentType":5126,"count":2,"type":"SCALAR"},
               {"bufferView":3,"componentType":5126,"count":2,"type":"VEC4"}])";
const std::string kAnimation = R"("animations":[{"samplers":[{"input":2,"output":3}],
  "channels":[{"sampler":0,"target":{"node":1,"path":"rotation"}}]}])";

std::string document(const std::vector<std::string>& members) {
    std::string text = R"({"asset":{"version":"2.0"})";
    for (const std::string& member : members)
        text += "," + member;
    return text + "}";
}

/// The triangle's document with one piece of text put in place of another.
std::string changed(const std::string& from, const std::string& to) {
    std::string text = document({kNodes, kMeshes, kBuffers, kAnimation});
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

class GltfTest : public testing::Test {
  protected:
    MeshScene read(const std::string& json) {
        return openMesh(scratch.write("scene.glb", glb(json, chunk())));
    }
    std::string refused(const std::string& json) {
        return refusal(scratch.write("scene.glb", glb(json, chunk())));
    }
    void says(const std::string& json, const std::string& what) {
        const std::string error = refused(json);
        EXPECT_NE(error.find(what), std::string::npos) << error << "\n for " << json;
    }
    ScratchFolder scratch;
};

TEST_F(GltfTest, NodesStandInEachOtherAndMove) {
    const MeshScene scene = read(document({kNodes, kMeshes, kBuffers, kAnimation}));
    EXPECT_EQ(scene.triangles(), 1U);
    ASSERT_EQ(scene.nodes.size(), 2U);
    EXPECT_EQ(scene.nodes[1].name, "arm");
    EXPECT_EQ(scene.nodes[1].parent, 0);
    EXPECT_EQ(scene.periodS, 2);
    const auto tip = [&](double seconds) {
        return glm::dvec3(scene.transforms(seconds)[1] * glm::dvec4(1, 0, 0, 1));
    };
    // From no turn to a quarter about z in two seconds, again and again.
    const double half = std::numbers::sqrt2 / 2;
    for (const auto& [seconds, x, y] : {std::array{0.0, 11.0, 0.0},
                                        {1.0, 10 + half, half},
                                        {3.0, 10 + half, half},
                                        {-1.0, 10 + half, half}}) {
        EXPECT_NEAR(tip(seconds).x, x, 1e-6) << seconds; // the file's turns are floats
        EXPECT_NEAR(tip(seconds).y, y, 1e-6) << seconds;
    }
}

TEST_F(GltfTest, StripsAndFansAreTriangles) {
    const MeshScene strip = read(changed("\"indices\":1", "\"indices\":1,\"mode\":5"));
    EXPECT_EQ(strip.indices, (std::vector<std::uint32_t>{0, 1, 2}));
    const MeshScene fan = read(changed("\"indices\":1", "\"mode\":6"));
    EXPECT_EQ(fan.indices, (std::vector<std::uint32_t>{0, 1, 2}));
}

/// The rule that gltf_materials.hpp states, at its ends.
TEST_F(GltfTest, MetallicRoughnessBecomesBlinnPhong) {
    const auto matte = devices::mesh::blinnPhong({0.5F, 0.25F, 1}, 0, 1);
    EXPECT_EQ(matte.diffuse, glm::vec3(0.5F, 0.25F, 1));
    EXPECT_EQ(matte.shininess, 0);
    EXPECT_NEAR(matte.specular.r, 0.04, 1e-6);
    const auto metal = devices::mesh::blinnPhong({0.5F, 0.25F, 1}, 1, 0.5F);
    EXPECT_EQ(metal.diffuse, glm::vec3(0.25F, 0.125F, 0.5F));
    EXPECT_NEAR(metal.shininess, 30, 1e-4);
    EXPECT_EQ(metal.specular, glm::vec3(1)); // 38/8 of the colour is more than all light
    EXPECT_EQ(devices::mesh::blinnPhong({1, 1, 1}, 1, 0).shininess, devices::mesh::kMostShininess);
}

TEST_F(GltfTest, MissingAndEscapingTexturesAreLeftOut) {
    for (const std::string uri : {"gone.png", "../x.png", "%2e%2e/x.png", "http://x/y.png",
                                  "/etc/passwd", "data:image/png;base64,AAAA", "data:oops"}) {
        const MeshScene scene = read(document(
            {kNodes, R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}])",
             kBuffers, R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])",
             R"("textures":[{"source":0}],"images":[{"uri":")" + uri + R"("}])"}));
        EXPECT_EQ(scene.repairs.textures, 1U) << uri;
        EXPECT_EQ(scene.triangles(), 1U) << uri;
    }
}

TEST_F(GltfTest, WhatReachesBeyondItsBytesIsRefused) {
    says(changed("\"count\":3,\"type\":\"VEC3\"", "\"count\":4,\"type\":\"VEC3\""),
         "accessor 0 reaches beyond");
    says(changed("\"count\":3,\"type\":\"VEC3\"", "\"count\":100000000,\"type\":\"VEC3\""),
         "count");
    says(changed("\"count\":3,\"type\":\"VEC3\"", "\"count\":-1,\"type\":\"VEC3\""),
         "count = '-1'");
    says(changed("\"count\":3,\"type\":\"VEC3\"", "\"count\":1e30,\"type\":\"VEC3\""), "count");
    says(changed("\"byteLength\":36", "\"byteLength\":4000000000"), "byteLength");
    says(changed("\"byteLength\":84", "\"byteLength\":200000000"), "of a buffer that has 84 bytes");
    says(changed("\"byteOffset\":36", "\"byteOffset\":83"), "byteLength");
    says(changed("\"indices\":1", "\"indices\":77"), "accessor 77 is missing");
    says(changed("\"POSITION\":0", "\"POSITION\":1"), "POSITION is no VEC3");
    says(changed("\"POSITION\":0", "\"POSITION\":\"x\""), "POSITION = '\"x\"'");
    says(changed("\"mesh\":0", "\"mesh\":1"), "mesh = '1'");
    says(changed("\"buffer\":0", "\"buffer\":9"), "buffer = '9'");
    says(changed("5126", "5130"), "componentType = '5130'");
    says(changed("\"VEC3\"", "\"MAT4\""), "type = 'MAT4'");
    says(changed("\"children\":[1]", "\"children\":[0]"), "node 0 has two parents or is its own");
    says(changed("\"children\":[1]", "\"children\":[1,1]"), "node 1 has two parents");
    says(changed("\"children\":[1]", "\"children\":[5]"), "children = '5'");
    says(changed("[10,0,0]", "[1e300,0,0]"), "translation = '1e+300'");
    says(changed("[10,0,0]", "[10,0]"), "translation has not 3 numbers");
    says(changed("\"output\":3", "\"output\":2"), "input and output do not fit");
}

TEST_F(GltfTest, WhatIsNoDocumentIsRefused) {
    EXPECT_NE(refused(""), "");
    EXPECT_NE(refused(document({"\"meshes\":5"})), "");
    says("[]", "asset.version = ''");
    says(R"({"asset":{"version":"1.0"}})", "asset.version = '1.0'");
    says(R"({"asset":{"version":"2.0"}})", "no triangles");
    says(document(
             {kNodes, kMeshes, kBuffers, R"("extensionsRequired":["KHR_draco_mesh_compression"])"}),
         "KHR_draco_mesh_compression");
    constexpr std::size_t kDeep = 200'000;
    says(document({"\"extras\":" + std::string(kDeep, '[') + std::string(kDeep, ']')}),
         "nested too deeply");
    devices::mesh::MeshLimits limits;
    limits.jsonBytes = 8;
    EXPECT_NE(refusal(scratch.write("scene.gltf", document({})), limits).find("allowed 8"),
              std::string::npos);
}

/// Whatever byte is damaged or missing: a scene whose numbers are in range, or one line.
TEST_F(GltfTest, DamagedAnywhereItIsReadOrRefused) {
    const std::string whole = glb(document({kNodes, kMeshes, kBuffers, kAnimation}), chunk());
    for (std::size_t length = 0; length < whole.size(); length += 3)
        EXPECT_NE(refusal(scratch.write("cut.glb", whole.substr(0, length))), "") << length;
    int read = 0;
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x15);
        const auto file = scratch.write("damaged.glb", damaged);
        if (!refusal(file).empty()) continue;
        ++read;
        const MeshScene scene = openMesh(file);
        for (const std::uint32_t index : scene.indices)
            ASSERT_LT(index, scene.vertices.size());
        static_cast<void>(devices::mesh::extent(scene));
    }
    EXPECT_GT(read, 50); // names, values of vertices
}

TEST_F(GltfTest, SamplesOfTheFormatAreWhole) {
    AUTOSTEREO_NEED_DATA("meshes/gltf");
    const MeshScene box = openMesh(dataDir() / "meshes/gltf/BoxTextured/BoxTextured.gltf");
    EXPECT_EQ(box.triangles(), 12U);
    EXPECT_EQ(box.textures.size(), 1U);
    EXPECT_EQ(box.repairs.textures, 0U);
    const MeshScene engine = openMesh(dataDir() / "meshes/gltf/2CylinderEngine.glb");
    EXPECT_EQ(engine.repairs.badTriangles, 0U);
    EXPECT_EQ(engine.nodes.size(), 82U);
    std::printf("2CylinderEngine: %s\n", devices::mesh::describe(engine).c_str());
}

} // namespace
} // namespace autostereo::test

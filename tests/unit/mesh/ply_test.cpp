// PLY in its three encodings, and what is refused.

#include "tests/unit/mesh/mesh_files.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autostereo::test {
namespace {

using devices::mesh::MeshScene;
using devices::mesh::openMesh;

std::string header(const std::string& format, const std::string& vertices, const std::string& faces,
                   const std::string& list = "uchar int") {
    return "ply\nformat " + format + " 1.0\ncomment made here\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty double z\nproperty uchar red\n"
           "element face " +
           faces + "\nproperty list " + list + " vertex_indices\nend_header\n";
}

/// A square as two triangles and once more as a polygon.
std::string binary(bool swapped) {
    std::string bytes;
    const auto put = [&](auto value) {
        std::string number = bytesOf(std::vector{value});
        if (swapped) std::reverse(number.begin(), number.end());
        bytes += number;
    };
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        put(static_cast<float>(x));
        put(static_cast<float>(y));
        put(0.5);
        put(std::uint8_t{9});
    }
    for (const auto& face : {std::vector{0, 1, 2}, {0, 2, 3}, {0, 1, 2, 3}}) {
        put(static_cast<std::uint8_t>(face.size()));
        for (const std::int32_t index : face)
            put(index);
    }
    return bytes;
}

constexpr const char* kText = "0 0 0.5 9\n1 0 0.5 9\n1 1 0.5 9\n0 1 0.5 9\n"
                              "3 0 1 2\n3 0 2 3\n4 0 1 2 3\n";

class PlyTest : public testing::Test {
  protected:
    std::string refused(const std::string& text) {
        return refusal(scratch.write("scene.ply", text));
    }
    ScratchFolder scratch;
};

TEST_F(PlyTest, AllThreeEncodingsGiveOneScene) {
    for (const std::string& text : {header("ascii", "4", "3") + kText,
                                    header("binary_little_endian", "4", "3") + binary(false),
                                    header("binary_big_endian", "4", "3") + binary(true)}) {
        const MeshScene scene = openMesh(scratch.write("scene.ply", text));
        EXPECT_EQ(scene.triangles(), 4U);
        ASSERT_EQ(scene.vertices.size(), 4U);
        EXPECT_EQ(scene.vertices[2].position, glm::vec3(1, 1, 0.5F));
        EXPECT_EQ(scene.vertices[2].normal, glm::vec3(0, 0, 1));
        EXPECT_EQ(scene.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 0, 1, 2, 0, 2, 3}));
    }
}

TEST_F(PlyTest, CountsThatTheFileCannotHoldAreRefusedAtOnce) {
    const auto says = [&](const std::string& text, const std::string& what) {
        const std::string error = refused(text);
        EXPECT_NE(error.find(what), std::string::npos) << error;
    };
    for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        says(header(format, "2000000000", "1") + kText, "more than the file has bytes for");
        says(header(format, "18446744073709551615", "1") + kText, "more than the file has");
        says(header(format, "4", "100000000") + kText, "more than the file has bytes for");
    }
    says(header("ascii", "99999999999999999999", "1"), "(allowed a count)");
    says(header("ascii", "-1", "1"), "element vertex = '-1' (allowed a count)");
    says(header("binary_little_endian", "0", "1", "uint int") + "\xff\xff\xff\x7f",
         "list vertex_indices");
    says(header("ascii", "0", "1", "int int") + "-3 1 2 3\n", "list vertex_indices");
    says(header("ascii", "4", "3", "float int") + kText, "a whole number as count");
    says("ply\nformat ascii 1.0\nelement vertex 999999999999\nend_header\n",
         "more than the file has");
}

TEST_F(PlyTest, WhatIsNoSceneIsRefused) {
    const auto says = [&](const std::string& text, const std::string& what) {
        const std::string error = refused(text);
        EXPECT_NE(error.find(what), std::string::npos) << error;
    };
    says("", "is no PLY file");
    says("ply\nformat ascii 1.0\n", "ends within the header");
    says("ply\nformat morse 1.0\nend_header\n", "format = 'morse'");
    says(header("ascii", "4", "1") + "0 0 0 9 1 0 0 9 1 1 0 9 0 1 0 9 3 0 1 4\n",
         "vertex_indices = '4' (allowed below 4)");
    says(header("ascii", "4", "1") + "0 0 0 9 1 0 0 9 1 1 0 9 0 1 0 9 3 0 1 -1\n", "is no vertex");
    says(header("ascii", "4", "1") + "0 0 0 9 1 0 0 9 1 1 0 9 0 1 0 9 3 0 1 nan\n", "is no vertex");
    says(header("ascii", "4", "0") + "0 0 0 9 1 0 0 9 1 1 0 9 0 1 0 9\n", "no triangles");
    says(header("ascii", "4", "1") + "0 0 0 9 1 0 0 9 1 1 0 9 0 1 0 9 3 0 1 x\n",
         "(allowed a number)");
}

TEST_F(PlyTest, NumbersThatAreNoneLoseTheirTriangles) {
    std::string bytes = binary(false);
    const double huge = 1e300;                                  // finite as double, not as float
    std::memcpy(bytes.data() + 1 * 17 + 8, &huge, sizeof huge); // z of vertex 1
    const MeshScene scene =
        openMesh(scratch.write("scene.ply", header("binary_little_endian", "4", "3") + bytes));
    EXPECT_EQ(scene.repairs.badTriangles, 2U);
    EXPECT_EQ(scene.indices, (std::vector<std::uint32_t>{0, 2, 3, 0, 2, 3}));
    const double none = std::numeric_limits<double>::quiet_NaN();
    std::memcpy(bytes.data() + 2 * 17 + 8, &none, sizeof none); // of vertex 2, which all use
    EXPECT_NE(refused(header("binary_little_endian", "4", "3") + bytes).find("finite corners"),
              std::string::npos);
}

TEST_F(PlyTest, CutOffAnywhereItIsRefused) {
    for (const std::string& whole : {header("ascii", "4", "3") + kText,
                                     header("binary_little_endian", "4", "3") + binary(false)})
        for (std::size_t length = 0; length + 2 < whole.size(); ++length)
            EXPECT_NE(refused(whole.substr(0, length)), "") << length << " of " << whole.size();
}

} // namespace
} // namespace autostereo::test

#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace autostereo::devices::mesh {

constexpr int kNone = -1; ///< in place of an index

/// In its node's frame, right-handed, y up as in glTF. Every number is finite, normals have length
/// one, uv (0, 0) is the texture's top left, which repeats.
struct MeshVertex {
    glm::vec3 position{0};
    glm::vec3 normal{0, 0, 1};
    glm::vec2 uv{0};
};

/// Blinn-Phong. Colours are shares of full light (linear), 0 to 1, but for emissive.
struct MeshMaterial {
    std::string name;
    glm::vec3 diffuse{0.8F}; ///< multiplies the texture; also answers ambient light
    glm::vec3 specular{0};
    float shininess = 32; ///< exponent, 0 to kMostShininess
    glm::vec3 emissive{0};
    int texture = kNone; ///< of `MeshScene::textures`
};
constexpr float kMostShininess = 1024;

/// sRGB as in the file, alpha ignored, top row first.
struct MeshTexture {
    int width = 0;
    int height = 0;
    std::vector<std::byte> rgba;
};

/// A run of `MeshScene::indices`, three a triangle, counter-clockwise from outside.
struct MeshPart {
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0;
    int material = 0; ///< of `MeshScene::materials`
};

/// Where a node stands in its parent: scaled, then rotated, then moved; or as a matrix, which
/// nothing animates.
struct MeshPose {
    glm::dvec3 translation{0};
    glm::dquat rotation{1, 0, 0, 0};
    glm::dvec3 scale{1};
    std::optional<glm::dmat4> matrix{};

    [[nodiscard]] glm::dmat4 transform() const;
};

struct MeshNode {
    std::string name;
    int parent = kNone; ///< always lower than the node's own index
    MeshPose pose;
    std::vector<MeshPart> parts; ///< drawn in this node's frame
};

/// One value of a node's pose over time, glTF's sampler.
struct MeshChannel {
    enum class Path { Translation, Rotation, Scale };
    enum class Between { Step, Linear };
    int node = 0;
    Path path = Path::Translation;
    Between between = Between::Linear;
    std::vector<float> seconds;     ///< rising
    std::vector<glm::dvec4> values; ///< as many; rotations as x, y, z, w
};

/// What was wrong in a file and left out or put right, so that the rest can be shown.
struct MeshRepairs {
    std::size_t badTriangles = 0; ///< left out: a corner is no finite place
    std::size_t badNormals = 0;   ///< of no length or not finite: replaced by the faces' own
    std::size_t badUvs = 0;       ///< not finite: 0
    std::size_t badMaterials = 0; ///< numbers that are none, or unknown names: the default
    std::size_t textures = 0;     ///< not there, unreadable or outside of the folder: left out
    std::vector<std::string> why; ///< a line each, the first few
};

/// A scene of lit triangles. A plain value, in memory bounded by MeshLimits.
struct MeshScene {
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices;  ///< all below vertices.size()
    std::vector<MeshNode> nodes;         ///< parents before children
    std::vector<MeshMaterial> materials; ///< at least one
    std::vector<MeshTexture> textures;
    std::vector<MeshChannel> channels; ///< played over and over, all over the same period
    double periodS = 0;                ///< of the animation; 0: nothing moves
    MeshRepairs repairs;

    /// Triangles that are drawn: a part that two nodes draw counts twice.
    [[nodiscard]] std::size_t triangles() const;
    /// Every node's way to the scene's frame, at a time.
    [[nodiscard]] std::vector<glm::dmat4> transforms(double seconds = 0) const;
};

/// What a scene may hold; more is an error, found before memory is asked for.
struct MeshLimits {
    std::size_t fileBytes = 256U << 20U; ///< of each file
    std::size_t jsonBytes = 32U << 20U; ///< of a glTF document; the tree made of it takes up to 20x
    std::size_t vertices = 4'000'000;
    std::size_t indices = 24'000'000; ///< drawn, nodes counted
    std::size_t nodes = 65'536;
    std::size_t parts = 65'536; ///< drawn, nodes counted
    std::size_t materials = 4096;
    std::size_t textures = 64;
    std::size_t textureBytes = 256U << 20U; ///< all of them, decoded
    std::size_t keys = 1'000'000;           ///< of animation
};

/// What a scene fills.
struct MeshExtent {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
    double around = 0; ///< farthest from the box's vertical axis

    [[nodiscard]] glm::dvec3 middle() const { return (low + high) / 2.0; }
};
/// Of a scene that is turned by `turn`, at all of 16 moments of its animation.
[[nodiscard]] MeshExtent extent(const MeshScene& scene, const glm::dmat3& turn = glm::dmat3(1));

} // namespace autostereo::devices::mesh

#include "gpu/scene/scene_model.hpp"

#include "gpu/gl/error.hpp"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>

namespace autostereo::gpu {

namespace {

using devices::mesh::MeshScene;
using devices::mesh::MeshTexture;
using devices::mesh::MeshVertex;

gl::Texture makeTexture(const MeshTexture& picture) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (picture.width > largest || picture.height > largest)
        throw GlError("gl: a scene's texture of " + std::to_string(picture.width) + "x" +
                      std::to_string(picture.height) + " is larger than the driver allows (" +
                      std::to_string(largest) + ")");
    gl::Texture texture = gl::Texture::withLevels(GL_SRGB8_ALPHA8, picture.width, picture.height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture.name(), 0, 0, 0, picture.width, picture.height, GL_RGBA,
                        GL_UNSIGNED_BYTE, picture.rgba.data());
    glGenerateTextureMipmap(texture.name());
    return texture;
}

/// 0, 1, 2, ...: an attribute that stands still within a draw and tells its part.
std::vector<GLuint> countedUp(std::size_t count) {
    std::vector<GLuint> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0U);
    return numbers;
}

template<class Value>
gl::Buffer makeBuffer(const std::vector<Value>& values) {
    return gl::makeBuffer(sizeof(Value) * values.size(), values.data(), 0);
}

/// What turns normals, scaled so that its numbers fit into floats. A node squashed flat has no
/// inverse: its normals turn as its places do.
glm::dmat3 normalsOf(const glm::dmat3& turn) {
    const glm::dmat3 normals =
        glm::determinant(turn) != 0 ? glm::transpose(glm::inverse(turn)) : turn;
    double largest = 0;
    for (int i = 0; i < 9; ++i)
        largest = std::max(largest, std::abs(normals[i / 3][i % 3]));
    return largest > 0 && std::isfinite(largest) ? normals / largest : glm::dmat3(1);
}

} // namespace

SceneModel::SceneModel(const MeshScene& scene) {
    for (const MeshTexture& picture : scene.textures)
        textures_.push_back(makeTexture(picture));
    textures_.push_back(makeTexture({1, 1, std::vector<std::byte>(4, std::byte{255})}));
    for (std::size_t node = 0; node < scene.nodes.size(); ++node)
        for (const devices::mesh::MeshPart& part : scene.nodes[node].parts)
            if (part.indexCount > 0)
                draws_.push_back(
                    {static_cast<GLsizei>(part.indexCount), part.firstIndex, static_cast<int>(node),
                     part.material,
                     scene.materials[static_cast<std::size_t>(part.material)].texture});
    std::ranges::stable_sort(draws_, {}, &Draw::texture);
    const auto perRow = static_cast<std::size_t>(ScenePart::kPerRow);
    const std::size_t rows = (draws_.size() + perRow - 1) / perRow;
    parts_.resize(rows * perRow);
    partTexels_ =
        gl::Texture(GL_RGBA32F, ScenePart::kTexels * ScenePart::kPerRow, static_cast<int>(rows));
    upload(scene);
    describeVertices();
}

void SceneModel::upload(const MeshScene& scene) {
    vertices_ = makeBuffer(scene.vertices);
    indices_ = makeBuffer(scene.indices);
    numbers_ = makeBuffer(countedUp(draws_.size()));
    if (glGetError() == GL_OUT_OF_MEMORY)
        throw GlError("gl: not enough memory for a scene of " + std::to_string(scene.triangles()) +
                      " triangles");
}

void SceneModel::describeVertices() {
    vertexArray_ = gl::makeVertexArray();
    const GLuint array = vertexArray_.name();
    glVertexArrayVertexBuffer(array, 0, vertices_.name(), 0, sizeof(MeshVertex));
    glVertexArrayVertexBuffer(array, 1, numbers_.name(), 0, sizeof(GLuint));
    glVertexArrayElementBuffer(array, indices_.name());
    const auto attribute = [&](GLuint number, GLint components, std::size_t offset) {
        glEnableVertexArrayAttrib(array, number);
        glVertexArrayAttribBinding(array, number, 0);
        glVertexArrayAttribFormat(array, number, components, GL_FLOAT, GL_FALSE,
                                  static_cast<GLuint>(offset));
    };
    attribute(0, 3, offsetof(MeshVertex, position));
    attribute(1, 3, offsetof(MeshVertex, normal));
    attribute(2, 2, offsetof(MeshVertex, uv));
    constexpr GLuint kPartNumber = 3, kNever = 1U << 20U; // instances: more than views
    glEnableVertexArrayAttrib(array, kPartNumber);
    glVertexArrayAttribBinding(array, kPartNumber, 1);
    glVertexArrayAttribIFormat(array, kPartNumber, 1, GL_UNSIGNED_INT, 0);
    glVertexArrayBindingDivisor(array, 1, kNever);
}

void SceneModel::place(const MeshScene& scene, double seconds, const glm::dmat4& toDisplay) {
    const std::vector<glm::dmat4> nodes = scene.transforms(seconds);
    for (std::size_t i = 0; i < draws_.size(); ++i) {
        const devices::mesh::MeshMaterial& material =
            scene.materials[static_cast<std::size_t>(draws_[i].material)];
        const glm::dmat4 place = toDisplay * nodes[static_cast<std::size_t>(draws_[i].node)];
        parts_[i] = {place, glm::dmat4(normalsOf(glm::dmat3(place))),
                     glm::vec4(material.diffuse, material.shininess),
                     glm::vec4(material.specular, 0), glm::vec4(material.emissive, 0)};
    }
    glTextureSubImage2D(partTexels_.name(), 0, 0, 0, partTexels_.width(), partTexels_.height(),
                        GL_RGBA, GL_FLOAT, parts_.data());
}

void SceneModel::draw(int instances) const {
    glBindTextureUnit(1, partTexels_.name());
    glBindVertexArray(vertexArray_.name());
    int bound = -2;
    for (std::size_t i = 0; i < draws_.size(); ++i) {
        const Draw& draw = draws_[i];
        if (draw.texture != bound) {
            bound = draw.texture;
            const std::size_t texture =
                bound >= 0 ? static_cast<std::size_t>(bound) : textures_.size() - 1;
            glBindTextureUnit(0, textures_[texture].name());
        }
        const std::size_t bytes = sizeof(GLuint) * draw.firstIndex; // GL takes them as a pointer
        const auto* const offset =
            reinterpret_cast<const void*>(bytes); // NOLINT(performance-no-int-to-ptr)
        glDrawElementsInstancedBaseInstance(GL_TRIANGLES, draw.indexCount, GL_UNSIGNED_INT, offset,
                                            instances, static_cast<GLuint>(i));
    }
}

} // namespace autostereo::gpu

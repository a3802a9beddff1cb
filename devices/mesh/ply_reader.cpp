#include "devices/mesh/ply_values.hpp"
#include "devices/mesh/readers.hpp"

#include <array>
#include <cmath>

namespace autostereo::devices::mesh {

namespace {

/// Doubles beyond float's range become infinite, which `finished` leaves out.
float narrowed(double value) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    if (std::abs(value) > kLargest) return std::numeric_limits<float>::quiet_NaN();
    return static_cast<float>(value);
}

class PlyReader {
  public:
    explicit PlyReader(const MeshFile& file)
        : file_(file), lines_(file.bytes, file.name), header_(readPlyHeader(lines_)),
          values_(lines_, header_.format) {
        draft_.scene.materials.push_back({.name = "default"});
    }

    MeshDraft read() {
        for (const PlyElement& element : header_.elements)
            for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i)
                readOne(element);
        checkIndices();
        MeshScene& scene = draft_.scene;
        scene.nodes.push_back(
            {.name = file_.name,
             .pose = {},
             .parts = {{0, static_cast<std::uint32_t>(scene.indices.size()), 0}}});
        return std::move(draft_);
    }

  private:
    void readOne(const PlyElement& element) {
        const bool isVertex = element.name == "vertex", isFace = element.name == "face";
        if (isVertex) {
            allow(draft_.scene.vertices.size() + 1, file_.limits.vertices, "vertices");
            draft_.scene.vertices.push_back({.normal = glm::vec3(0)});
        }
        for (const PlyProperty& property : element.properties) {
            if (property.isList) {
                const bool isPolygon = property.name == "vertex_indices" ||
                                       property.name == "vertex_index"; // both are in use
                readList(property, isFace && isPolygon);
            } else {
                const double value = values_.next(property.type);
                if (isVertex) put(draft_.scene.vertices.back(), property.name, narrowed(value));
            }
        }
    }
    static void put(MeshVertex& vertex, std::string_view name, float value) {
        if (name == "x") vertex.position.x = value;
        if (name == "y") vertex.position.y = value;
        if (name == "z") vertex.position.z = value;
        if (name == "nx") vertex.normal.x = value;
        if (name == "ny") vertex.normal.y = value;
        if (name == "nz") vertex.normal.z = value;
        if (name == "s" || name == "u" || name == "texture_u") vertex.uv.x = value;
        if (name == "t" || name == "v" || name == "texture_v") vertex.uv.y = 1 - value;
    }
    /// A polygon becomes a fan.
    void readList(const PlyProperty& list, bool isPolygon) {
        const std::size_t count = values_.nextCount(list);
        std::vector<std::uint32_t>& indices = draft_.scene.indices;
        std::array<std::uint32_t, 2> fan{};
        for (std::size_t i = 0; i < count; ++i) {
            const double value = values_.next(list.type);
            if (!isPolygon) continue;
            if (!(value >= 0 && value < 4294967295.0))
                throw DeviceError(list.name + " = '" + std::to_string(value) + "' is no vertex");
            const auto now = static_cast<std::uint32_t>(value);
            if (i >= 2) {
                allow(indices.size() + 3, file_.limits.indices, "indices");
                indices.insert(indices.end(), {fan[0], fan[1], now});
            }
            fan[i == 0 ? 0 : 1] = now;
        }
    }
    /// Faces may come before their vertices.
    void checkIndices() const {
        const std::size_t count = draft_.scene.vertices.size();
        for (const std::uint32_t index : draft_.scene.indices)
            if (index >= count)
                throw DeviceError("vertex_indices = '" + std::to_string(index) +
                                  "' (allowed below " + std::to_string(count) + ")");
    }

    const MeshFile& file_;
    TextLines lines_;
    PlyHeader header_;
    PlyValues values_;
    MeshDraft draft_;
};

} // namespace

MeshDraft readPly(const MeshFile& file) { return PlyReader(file).read(); }

} // namespace autostereo::devices::mesh

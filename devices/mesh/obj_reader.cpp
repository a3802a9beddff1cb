#include "devices/mesh/mtl_reader.hpp"
#include "devices/mesh/readers.hpp"
#include "devices/mesh/text_lines.hpp"

#include <array>
#include <functional>
#include <unordered_map>

namespace autostereo::devices::mesh {

namespace {

/// A corner of a face: numbers of place, texture coordinate and normal, from 0; kNone: not given.
using Corner = std::array<int, 3>;
struct CornerHash {
    std::size_t operator()(const Corner& corner) const {
        std::size_t hash = 0;
        for (const int number : corner)
            hash = hash * 0x9e3779b97f4a7c15U + static_cast<std::size_t>(number + 1);
        return hash ^ hash >> 29U;
    }
};

class ObjReader {
  public:
    explicit ObjReader(const MeshFile& file) : file_(file), lines_(file.bytes, file.name) {
        draft_.scene.materials.push_back({.name = "default"});
        draft_.scene.nodes.push_back({.name = file.name, .pose = {}, .parts = {}});
    }

    MeshDraft read() {
        while (lines_.next())
            readLine(lines_.word());
        endPart();
        return std::move(draft_);
    }

  private:
    void readLine(std::string_view key) {
        if (key == "v") places_.push_back(vector3("v"));
        if (key == "vn") normals_.push_back(vector3("vn"));
        if (key == "vt") uvs_.push_back(textureCoordinate());
        if (key == "f") face();
        if (key == "usemtl") use(lines_.remainder());
        if (key == "mtllib")
            readMtl(file_, std::string(lines_.remainder()), draft_.scene, materials_);
    }
    glm::vec3 vector3(const char* what) {
        allow(std::max(places_.size(), normals_.size()) + 1, file_.limits.vertices, "vertices");
        const float x = lines_.number(what), y = lines_.number(what);
        return {x, y, lines_.number(what)};
    }
    glm::vec2 textureCoordinate() {
        allow(uvs_.size() + 1, file_.limits.vertices, "texture coordinates");
        const float u = lines_.number("vt");
        return {u, 1 - lines_.optionalNumber("vt").value_or(0)}; // the file's v goes up
    }

    /// "7", "7/8", "7//9" or "7/8/9"; negative ones count from the end of what was read so far.
    Corner corner(std::string_view text) {
        const std::array<std::size_t, 3> counts{places_.size(), uvs_.size(), normals_.size()};
        Corner corner{kNone, kNone, kNone};
        std::string_view rest = text;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string_view part = rest.substr(0, rest.find('/'));
            if (!part.empty()) {
                long long number = 0;
                const auto [end, error] =
                    std::from_chars(part.data(), part.data() + part.size(), number);
                const auto count = static_cast<long long>(counts[i]);
                if (error != std::errc{} || end != part.data() + part.size() || number == 0 ||
                    number > count || number < -count)
                    lines_.fail("f", text, "1 to " + std::to_string(count));
                corner[i] = static_cast<int>(number > 0 ? number - 1 : count + number);
            } else if (i == 0) {
                lines_.fail("f", text, "a number of a vertex first");
            }
            if (part.size() == rest.size()) return corner;
            rest.remove_prefix(part.size() + 1);
        }
        lines_.fail("f", text, "at most three numbers a corner");
    }
    std::uint32_t vertex(const Corner& corner) {
        const auto next = static_cast<std::uint32_t>(draft_.scene.vertices.size());
        const auto [known, isNew] = vertices_.try_emplace(corner, next);
        if (!isNew) return known->second;
        allow(next + std::size_t{1}, file_.limits.vertices, "vertices");
        const auto at = [](const auto& list, int number, auto absent) {
            return number == kNone ? absent : list[static_cast<std::size_t>(number)];
        };
        draft_.scene.vertices.push_back({at(places_, corner[0], glm::vec3(0)),
                                         at(normals_, corner[2], glm::vec3(0)),
                                         at(uvs_, corner[1], glm::vec2(0))});
        // The first vertex of a place stands for all of them.
        const auto [place, first] = firstOfPlace_.try_emplace(corner[0], next);
        draft_.places.push_back(place->second);
        return next;
    }
    void face() {
        std::vector<std::uint32_t>& indices = draft_.scene.indices;
        std::uint32_t first = 0, last = 0;
        std::size_t corners = 0;
        for (std::string_view text = lines_.word(); !text.empty() && text.front() != '#';
             text = lines_.word(), ++corners) {
            const std::uint32_t now = vertex(corner(text));
            if (corners == 0) first = now;
            if (corners >= 2) {
                allow(indices.size() + 3, file_.limits.indices, "indices");
                indices.insert(indices.end(), {first, last, now});
            }
            last = now;
        }
        if (corners < 3) lines_.fail("f", std::to_string(corners), "three corners and more");
    }

    void use(std::string_view name) {
        endPart();
        const auto known = materials_.find(name);
        material_ = known == materials_.end() ? 0 : known->second;
        if (known == materials_.end()) ++draft_.scene.repairs.badMaterials;
    }
    void endPart() {
        const auto end = static_cast<std::uint32_t>(draft_.scene.indices.size());
        if (end > partStart_)
            draft_.scene.nodes.front().parts.push_back({partStart_, end - partStart_, material_});
        partStart_ = end;
    }

    const MeshFile& file_;
    TextLines lines_;
    MeshDraft draft_;
    std::vector<glm::vec3> places_, normals_;
    std::vector<glm::vec2> uvs_;
    std::unordered_map<Corner, std::uint32_t, CornerHash> vertices_;
    std::unordered_map<int, std::uint32_t> firstOfPlace_;
    std::map<std::string, int, std::less<>> materials_;
    int material_ = 0;
    std::uint32_t partStart_ = 0;
};

} // namespace

MeshDraft readObj(const MeshFile& file) { return ObjReader(file).read(); }

} // namespace autostereo::devices::mesh

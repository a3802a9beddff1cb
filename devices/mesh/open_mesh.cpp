#include "devices/mesh/open_mesh.hpp"

#include "devices/content_kind.hpp"
#include "devices/input.hpp"
#include "devices/mesh/readers.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <new>

namespace autostereo::devices::mesh {

namespace {

MeshDraft readByName(const MeshFile& file, const std::string& extension) {
    if (extension == ".obj") return readObj(file);
    if (extension == ".ply") return readPly(file);
    return readGltf(file);
}

/// Nodes may put finite corners anywhere, and all into one point.
void requirePlace(const MeshScene& scene) {
    const MeshExtent box = extent(scene);
    const double size = glm::length(box.high - box.low);
    if (!std::isfinite(size) || !(size > 0))
        throw DeviceError("its triangles are nowhere, or all in one point");
}

std::string counted(std::size_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

} // namespace

bool isMeshFile(const std::filesystem::path& file) {
    return contentKind(file) == ContentKind::Scene;
}

void allow(std::size_t count, std::size_t most, const char* what) {
    if (count > most)
        throw DeviceError("too many " + std::string(what) + " (allowed " + std::to_string(most) +
                          ")");
}

MeshScene openMesh(const std::filesystem::path& file, const MeshLimits& limits) try {
    const SceneFolder folder(file, limits);
    const std::vector<std::byte> bytes = folder.readScene();
    MeshDraft draft =
        readByName({bytes, file.filename().string(), folder, limits}, extensionOf(file));
    allow(3 * draft.scene.triangles(), limits.indices, "indices");
    MeshScene scene = finished(std::move(draft));
    requirePlace(scene);
    return scene;
} catch (const DeviceError& error) {
    const std::string what = error.what();
    if (what.starts_with("cannot read " + file.string())) throw;
    throw DeviceError("cannot read " + file.string() + ": " + what, error.notFound());
} catch (const std::bad_alloc&) {
    throw DeviceError("cannot read " + file.string() + ": not enough memory");
} catch (const std::exception& error) {
    throw DeviceError("cannot read " + file.string() + ": " + error.what());
}

std::string describe(const MeshScene& scene) {
    std::string text = counted(scene.triangles(), "triangle") + ", " +
                       counted(scene.nodes.size(), "node") + ", " +
                       counted(scene.materials.size(), "material") + ", " +
                       counted(scene.textures.size(), "texture");
    if (scene.periodS > 0) text += ", animated";
    return text;
}

} // namespace autostereo::devices::mesh

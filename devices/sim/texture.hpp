#pragma once

#include <glm/vec3.hpp>

#include <cstdint>

namespace autostereo::devices::sim {

/// A point on a body's surface, in the body's frame (metres), with its outward normal.
struct SurfacePoint {
    glm::dvec3 position;
    glm::dvec3 normal;
    glm::dvec3 size; ///< of the body
};

struct Paint {
    glm::dvec3 color;         ///< gamma-encoded, 0..255
    double irReflectance = 0; ///< diffuse, 0..1
};

struct Material;
using Texture = Paint (*)(const Material&, const SurfacePoint&);

/// Each texture varies the base colour and reflectance. Detail is kept above about 8 mm, two
/// pixels of a 1280x720 camera at 3 m, so that sampling once a pixel does not alias.
struct Material {
    Texture texture = nullptr;
    glm::dvec3 color{128.0};
    double irReflectance = 0.5;
    double gloss = 0; ///< extra IR reflectance where the surface faces the light beside the lens
    std::uint32_t seed = 0;
};

[[nodiscard]] Paint plain(const Material&, const SurfacePoint&);
[[nodiscard]] Paint plaster(const Material&, const SurfacePoint&); ///< walls, ceiling, skirting
[[nodiscard]] Paint floorBoards(const Material&, const SurfacePoint&);
[[nodiscard]] Paint woodGrain(const Material&, const SurfacePoint&);   ///< along the body's x
[[nodiscard]] Paint landscape(const Material&, const SurfacePoint&);   ///< framed, faces -z
[[nodiscard]] Paint abstractArt(const Material&, const SurfacePoint&); ///< framed, faces -z
[[nodiscard]] Paint bookSpines(const Material&, const SurfacePoint&);  ///< shelves, face -z
[[nodiscard]] Paint mottled(const Material&, const SurfacePoint&);     ///< glaze, leaves, cloth
[[nodiscard]] Paint stripes(const Material&, const SurfacePoint&);     ///< along y
[[nodiscard]] Paint face(const Material&, const SurfacePoint&);        ///< looks towards -z
[[nodiscard]] Paint hair(const Material&, const SurfacePoint&);
[[nodiscard]] Paint chessboard(const Material&, const SurfacePoint&); ///< on the -z side

/// The pattern of `chessboard`: 10 x 7 squares, so 9 x 6 inner corners.
constexpr int kBoardColumns = 10;
constexpr int kBoardRows = 7;
constexpr double kBoardSquareM = 0.060;

} // namespace autostereo::devices::sim

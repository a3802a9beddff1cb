#include "devices/sim/texture.hpp"

#include "devices/sim/pattern.hpp"

#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace autostereo::devices::sim {
namespace {

constexpr double kSoftM = 0.004; // half the width of painted edges

/// The two coordinates that run in the face of a box.
glm::dvec2 inFace(const SurfacePoint& at) {
    if (std::abs(at.normal.x) > 0.5) return {at.position.z, at.position.y};
    if (std::abs(at.normal.y) > 0.5) return {at.position.x, at.position.z};
    return {at.position.x, at.position.y};
}

/// Long boards along x in rows along y, each with its own shade and grain.
double boards(glm::dvec2 p, double width, double length, std::uint32_t seed) {
    const double row = std::floor(p.y / width);
    const double shifted = p.x + length * cellValue(row, 17, seed);
    const double shade = cellValue(std::floor(shifted / length), row, seed);
    const double grain = valueNoise({p.x * 6 + 31 * shade, p.y * 60}, seed + 1);
    const double gaps = softBand(toGrid(p.y, width), 0.001, kSoftM) +
                        softBand(toGrid(shifted, length), 0.001, kSoftM);
    return (0.80 + 0.22 * shade + 0.12 * (grain - 0.5)) * (1 - 0.35 * std::min(gaps, 1.0));
}

/// Frame of a picture (`half`: its size): 1 on the frame, 0 on the canvas.
double frameShare(glm::dvec2 p, glm::dvec2 half, double width) {
    const double inside = std::min(half.x - std::abs(p.x), half.y - std::abs(p.y));
    return softStep(width - inside, kSoftM);
}

Paint framed(const Material& material, const SurfacePoint& at, const glm::dvec3& canvas) {
    const glm::dvec2 p{at.position.x, at.position.y};
    const double frame = at.normal.z < -0.5 ? frameShare(p, {at.size.x, at.size.y}, 0.030) : 1.0;
    return {glm::mix(canvas, material.color, frame), material.irReflectance};
}

} // namespace

Paint plain(const Material& material, const SurfacePoint&) {
    return {material.color, material.irReflectance};
}

Paint plaster(const Material& material, const SurfacePoint& at) {
    const glm::dvec2 p = inFace(at);
    const double cloud = valueNoise(p * 1.7, material.seed) - 0.5;
    const double stipple = valueNoise(p * 28.0, material.seed + 1) - 0.5;
    const double weave = valueNoise(p * glm::dvec2(70.0, 9.0), material.seed + 2) - 0.5;
    glm::dvec3 color = material.color * (1 + 0.07 * cloud + 0.05 * stipple + 0.03 * weave);
    if (std::abs(at.normal.y) < 0.5) {
        // Skirting board and the shade in the room's corners.
        const double aboveFloor = at.size.y - at.position.y;
        color = glm::mix(color, glm::dvec3(238, 232, 222), softStep(0.12 - aboveFloor, kSoftM));
        color *= 1 - 0.18 * std::exp(-aboveFloor / 0.10);
    }
    return {color, material.irReflectance};
}

Paint floorBoards(const Material& material, const SurfacePoint& at) {
    const glm::dvec2 p = inFace(at);
    return {material.color * boards({p.y, p.x}, 0.14, 1.3, material.seed), material.irReflectance};
}

Paint woodGrain(const Material& material, const SurfacePoint& at) {
    const glm::dvec2 p = inFace(at);
    const double warp = valueNoise(p * 2.5, material.seed) * 0.25;
    const double rings = 0.5 + 0.5 * std::sin((p.y + warp) * 95.0);
    const double grain = valueNoise({p.x * 8, p.y * 70}, material.seed + 1);
    return {material.color * (0.86 + 0.12 * rings + 0.14 * (grain - 0.5)), material.irReflectance};
}

Paint landscape(const Material& material, const SurfacePoint& at) {
    const glm::dvec2 p{at.position.x, at.position.y};
    const double down = p.y / at.size.y; // -1 top, 1 bottom
    glm::dvec3 color =
        glm::mix(glm::dvec3(72, 110, 168), glm::dvec3(252, 196, 120), softStep(down + 0.25, 0.7));
    const glm::dvec2 sun{0.3 * at.size.x, -0.15 * at.size.y};
    color = glm::mix(color, glm::dvec3(255, 240, 190), softDisc(p, sun, glm::dvec2(0.07)));
    const glm::dvec3 near{52, 84, 58};
    const glm::dvec3 far{150, 130, 150};
    for (int ridge = 0; ridge < 4; ++ridge) {
        const double scale = 3.0 + 1.5 * ridge;
        const double line = -0.05 + 0.24 * ridge +
                            0.5 * (valueNoise({p.x * scale + 9 * ridge, 0.5},
                                              material.seed + static_cast<std::uint32_t>(ridge)) -
                                   0.5);
        color = glm::mix(color, glm::mix(far, near, ridge / 3.0),
                         softStep((down - line) * at.size.y, kSoftM));
    }
    return framed(material, at, color);
}

Paint abstractArt(const Material& material, const SurfacePoint& at) {
    const glm::dvec2 p{at.position.x, at.position.y};
    glm::dvec3 color{236, 228, 208};
    constexpr int kDiscs = 7;
    const glm::dvec3 palette[] = {{196, 62, 48}, {238, 174, 58}, {40, 96, 128}, {70, 140, 120}};
    for (int disc = 0; disc < kDiscs; ++disc) {
        const auto value = [&](int which) { return cellValue(disc, which, material.seed); };
        const glm::dvec2 centre{(1.5 * value(0) - 0.75) * at.size.x,
                                (1.5 * value(1) - 0.75) * at.size.y};
        const double radius = (0.12 + 0.30 * value(2)) * at.size.x;
        color = glm::mix(color, palette[disc % 4], 0.85 * softDisc(p, centre, glm::dvec2(radius)));
    }
    color = glm::mix(color, glm::dvec3(40, 38, 44), softBand(p.x + 0.6 * p.y, 0.006, kSoftM));
    return framed(material, at, color);
}

Paint bookSpines(const Material& material, const SurfacePoint& at) {
    if (at.normal.z > -0.5) return woodGrain(material, at);
    constexpr double kShelf = 0.30, kBook = 0.042, kBoard = 0.024;
    const glm::dvec2 p{at.position.x, at.position.y + at.size.y};
    const double shelf = std::floor(p.y / kShelf);
    const double book = std::floor(p.x / kBook);
    const double hue = cellValue(book, shelf, material.seed);
    const glm::dvec3 phases = glm::dvec3(0.0, 0.33, 0.67) + hue;
    glm::dvec3 color =
        110.0 + 72.0 * glm::dvec3(std::cos(6.28318 * phases.x), std::cos(6.28318 * phases.y),
                                  std::cos(6.28318 * phases.z));
    color = glm::mix(color, glm::dvec3(150, 110, 74), 0.35);
    const double inShelf = p.y - shelf * kShelf; // 0 at the shelf's top board
    const double top = 0.045 + 0.07 * cellValue(book, shelf, material.seed + 1);
    color *= 0.75 + 0.25 * softStep(toGrid(p.x, kBook) - 0.006, 0.005);
    color = glm::mix(color, glm::dvec3(232, 214, 160),
                     0.8 * softBand(inShelf - top - 0.05, 0.008, kSoftM));
    color = glm::mix(glm::dvec3(44, 32, 26), color, softStep(inShelf - top, kSoftM));
    const double frame =
        std::max(softStep(kBoard - inShelf, kSoftM),
                 frameShare({at.position.x, at.position.y}, {at.size.x, at.size.y}, kBoard));
    return {glm::mix(color, material.color, frame), material.irReflectance};
}

Paint mottled(const Material& material, const SurfacePoint& at) {
    const glm::dvec3 p = at.position * 24.0;
    const double a = valueNoise({p.x + 0.7 * p.z, p.y}, material.seed);
    const double b = valueNoise({p.z - 0.7 * p.x, p.y * 2.1}, material.seed + 1);
    return {material.color * (0.78 + 0.44 * a * b + 0.18 * b), material.irReflectance};
}

Paint stripes(const Material& material, const SurfacePoint& at) {
    const double share = softBand(toGrid(at.position.y, 0.07), 0.012, 0.004);
    const double weave = valueNoise({at.position.x * 60, at.position.y * 60}, material.seed);
    const glm::dvec3 color = glm::mix(material.color, glm::dvec3(240, 232, 214), share);
    return {color * (0.95 + 0.08 * weave), material.irReflectance};
}

Paint hair(const Material& material, const SurfacePoint& at) {
    const double strand = valueNoise(
        {std::atan2(at.position.x, at.position.z) * 14, at.position.y * 14}, material.seed);
    return {material.color * (0.72 + 0.5 * strand), material.irReflectance};
}

Paint face(const Material& material, const SurfacePoint& at) {
    if (at.position.z > 0) return plain(material, at);
    // From the middle of the head, in metres; mirrored, because faces are.
    const double side = std::abs(at.position.x), down = at.position.y;
    const glm::dvec2 p{side, down};
    glm::dvec3 color = material.color;
    const auto paint = [&](const glm::dvec3& with, double share) {
        color = glm::mix(color, with, share);
    };
    paint({224, 128, 112}, 0.22 * softDisc(p, {0.045, 0.040}, {0.024, 0.018}));
    paint({248, 246, 240}, softDisc(p, {0.031, -0.008}, {0.0155, 0.0095}));
    paint({58, 72, 60}, softDisc(p, {0.031, -0.008}, {0.0080, 0.0085}));
    paint({16, 14, 16}, softDisc(p, {0.031, -0.008}, {0.0040, 0.0042}));
    const double brow = -0.034 + 6 * (side - 0.031) * (side - 0.031) * 4;
    paint({74, 48, 34},
          softBand(down - brow, 0.003, 0.0025) * softBand(side - 0.031, 0.017, 0.003));
    const double smile = 0.066 - 7 * side * side;
    paint({172, 62, 62}, softBand(down - smile, 0.0045, 0.0025) * softBand(side, 0.027, 0.003));
    return {color, material.irReflectance};
}

Paint chessboard(const Material& material, const SurfacePoint& at) {
    if (at.normal.z > -0.5) return {material.color, material.irReflectance};
    constexpr double kSoftBoardM = 0.0012; // about half a pixel at the board, edges stay unbiased
    const glm::dvec2 p{at.position.x + 0.5 * kBoardColumns * kBoardSquareM,
                       at.position.y + 0.5 * kBoardRows * kBoardSquareM};
    // 1 and -1 in turn, changing softly at the lines between squares (not at the outer ones).
    const auto alternate = [](double x, int squares) {
        const double line =
            std::clamp(std::round(x / kBoardSquareM), 1.0, static_cast<double>(squares - 1));
        const double sign = std::fmod(line, 2.0) == 0.0 ? 1.0 : -1.0;
        return sign * (2 * softStep(x - line * kBoardSquareM, kSoftBoardM) - 1);
    };
    const double inside =
        softBand(at.position.x, 0.5 * kBoardColumns * kBoardSquareM, kSoftBoardM) *
        softBand(at.position.y, 0.5 * kBoardRows * kBoardSquareM, kSoftBoardM);
    const double black =
        inside * (0.5 + 0.5 * alternate(p.x, kBoardColumns) * alternate(p.y, kBoardRows));
    const glm::dvec3 ink{26, 26, 28};
    constexpr double kInkReflectance = 0.12; // toner absorbs near infrared, too
    return {glm::mix(material.color, ink, black),
            glm::mix(material.irReflectance, kInkReflectance, black)};
}

} // namespace autostereo::devices::sim

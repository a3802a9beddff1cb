#include "calib/look.hpp"

#include "calib/light_field.hpp"
#include "calib/srgb.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace autostereo::calib {

namespace {

/// Less is rounding of running sums, not light: a tent's corner of 20 x 20 pixels weighs 1e-5.
constexpr float kDark = 1e-9F;

struct Tent {
    int columns;
    int rows;
};

Tent tentOf(const DisplayOptics& optics, double eyeDistance) {
    const double cyclesPerPixel =
        std::abs(optics.subpixels.pixelM * optics.lenses.cyclesPerM(eyeDistance));
    const int columns = std::max(1, static_cast<int>(std::lround(1 / cyclesPerPixel)));
    // Axes so steep that they need more rows than three lenses are wide repeat along the row first.
    const double slope = 1 / std::abs(optics.lenses.slant);
    return {columns, slope <= 3 * columns ? std::max(1, static_cast<int>(std::lround(slope))) : 1};
}

/// One colour's light as the eye sees it, pixel by pixel; counts what is seen.
LightField lightOf(const DisplayOptics& optics, const LightModel& light, const glm::dvec3& eye,
                   std::span<const std::uint8_t> panel, const Srgb& srgb, std::size_t channel,
                   EyePicture& seen) {
    const SubpixelLayout& layout = optics.subpixels;
    const auto across = static_cast<std::size_t>(layout.width);
    LightField field(layout.width, layout.height);
    std::vector<double> shares(3 * across);
    for (int y = 0; y < layout.height; ++y) {
        seenShares(optics, light, eye, y, shares);
        const auto row = panel.subspan(3 * across * static_cast<std::size_t>(y), 3 * across);
        for (std::size_t x = 0; x < across; ++x) {
            const double share = shares[3 * x + channel];
            seen.lit += share > 0 ? 1 : 0;
            seen.meanShare += share / static_cast<double>(panel.size());
            field.at(static_cast<int>(x), y) = {srgb.light(row[3 * x + channel]) * share, share};
        }
    }
    return field;
}

/// Writes the mean of the light near each pixel where there is any and none is written yet; false:
/// some pixels have none.
bool write(const LightField& field, const Srgb& srgb, const SubpixelLayout& layout,
           std::size_t channel, std::vector<std::uint8_t>& rgb, std::vector<bool>& done) {
    const auto across = static_cast<std::size_t>(layout.width);
    bool all = true;
    for (std::size_t i = 0; i < field.values.size(); ++i) {
        if (done[i]) continue;
        const glm::vec2 light = field.values[i];
        all = all && light.y > kDark;
        if (!(light.y > kDark)) continue;
        done[i] = true;
        std::size_t y = i / across;
        if (layout.upsideDown) y = static_cast<std::size_t>(layout.height) - 1 - y;
        rgb[3 * (y * across + i % across) + channel] =
            srgb.level(static_cast<double>(light.x) / static_cast<double>(light.y));
    }
    return all;
}

void check(const DisplayOptics& optics, const glm::dvec3& eye, std::size_t samples) {
    const SubpixelLayout& layout = optics.subpixels;
    if (samples !=
        3 * static_cast<std::size_t>(layout.width) * static_cast<std::size_t>(layout.height))
        throw std::invalid_argument("look: the picture has not the panel's size");
    if (!(eye.z > std::max(0.0, optics.lenses.gapM)))
        throw std::invalid_argument("look: the eye is not in front of the display");
}

} // namespace

EyePicture look(const DisplayOptics& optics, const LightModel& light, const glm::dvec3& eye,
                std::span<const std::uint8_t> panel) {
    check(optics, eye, panel.size());
    const SubpixelLayout& layout = optics.subpixels;
    const Srgb srgb;
    EyePicture seen{std::vector<std::uint8_t>(panel.size(), 0)};
    const Tent first = tentOf(optics, eye.z);
    const int widest = 2 * std::max(layout.width, layout.height);
    for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t before = seen.lit;
        LightField field = lightOf(optics, light, eye, panel, srgb, c, seen);
        if (seen.lit == before) continue;
        std::vector<bool> done(panel.size() / 3);
        for (Tent tent = first; tent.columns < widest || tent.rows < widest;
             tent = {2 * tent.columns, 2 * tent.rows}) {
            field.blur(tent.columns, tent.rows);
            if (write(field, srgb, layout, c, seen.rgb, done)) break;
        }
    }
    return seen;
}

} // namespace autostereo::calib

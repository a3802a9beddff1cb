#include "calib/look.hpp"

#include "calib/light_field.hpp"
#include "calib/srgb.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace autostereo::calib {

namespace {

/// Less is rounding of running sums, not light: the corner of the widest tent weighs 1e-5.
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

/// Writes the mean of the light near each pixel where there is any; false: some pixels have none.
bool average(LightField field, const Tent& tent, const Srgb& srgb, const SubpixelLayout& layout,
             std::size_t channel, std::vector<std::uint8_t>& rgb, std::vector<bool>& done) {
    field.blur(tent.columns, tent.rows);
    bool all = true;
    for (std::size_t i = 0; i < field.values.size(); ++i) {
        if (done[i]) continue;
        const glm::vec2 light = field.values[i];
        all = all && light.y > kDark;
        if (!(light.y > kDark)) continue;
        done[i] = true;
        const auto across = static_cast<std::size_t>(layout.width);
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
    const auto across = 3 * static_cast<std::size_t>(layout.width);
    const Srgb srgb;
    EyePicture seen{std::vector<std::uint8_t>(panel.size(), 0)};

    std::array fields{LightField(layout.width, layout.height),
                      LightField(layout.width, layout.height),
                      LightField(layout.width, layout.height)};
    std::vector<double> shares(across);
    for (int y = 0; y < layout.height; ++y) {
        seenShares(optics, light, eye, y, shares);
        const auto row = panel.subspan(static_cast<std::size_t>(y) * across, across);
        for (std::size_t i = 0; i < across; ++i) {
            seen.lit += shares[i] > 0 ? 1 : 0;
            seen.meanShare += shares[i];
            fields.at(i % 3).at(static_cast<int>(i / 3), y) = {srgb.light(row[i]) * shares[i],
                                                               shares[i]};
        }
    }
    seen.meanShare /= static_cast<double>(panel.size());
    if (seen.lit == 0) return seen;

    const Tent first = tentOf(optics, eye.z);
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<bool> done(panel.size() / 3);
        const int widest = 2 * std::max(layout.width, layout.height);
        for (Tent tent = first; tent.columns < widest || tent.rows < widest;
             tent = {2 * tent.columns, 2 * tent.rows})
            if (average(fields.at(c), tent, srgb, layout, c, seen.rgb, done)) break;
    }
    return seen;
}

} // namespace autostereo::calib

#pragma once

#include "calib/display_profile.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <vector>

// The glass in front of the pixels in metres, from the numbers that its maker or its calibration
// gives, for tracing light. Shares no code with the maps that fill the panel, since it judges them.

namespace autostereo::calib {

/// Cylindrical lenses or slits side by side in a plane parallel to the panel. Display space:
/// metres, origin at the panel's centre, x right, y up, z to the viewer. Value type; reentrant.
struct LensArray {
    Optics::Kind kind = Optics::Kind::None;
    double pitchM = 0;   ///< from axis to axis along x, > 0
    double slant = 0;    ///< dx/dy of the axes
    double axisM = 0;    ///< x of one axis (or slit's centre) at y = 0
    double gapM = 0;     ///< height of the plane above the pixels, air-equivalent; < 0: behind them
    double aperture = 0; ///< width that an eye sees through one, cycles; 0: a line

    /// Where the sheet is deformed: cycles to add at a place of the lens plane. Empty: nowhere.
    PhaseGrid correction;
    glm::dvec2 correctedM{0}; ///< width and height that its nodes span around the centre

    /// Where the ray from a point of the panel to the eye crosses the plane, in periods; whole on
    /// an axis. `eye.z` > max(gapM, 0).
    [[nodiscard]] double coordinate(const glm::dvec3& eye, const glm::dvec2& panelPoint) const;
    /// Lens periods that an eye at that distance sees a step along x on the panel as.
    [[nodiscard]] double cyclesPerM(double eyeDistance) const {
        return (1 - gapM / eyeDistance) / pitchM;
    }
};

/// Where the light leaves the panel: sub-pixels' centres, as the maker's formula places them.
/// Boxes a third of a pixel wide. Value type; reentrant.
struct SubpixelLayout {
    int width = 0; ///< pixels
    int height = 0;
    double pixelM = 0; ///< square
    CellPattern pattern = CellPattern::Single;
    /// Of R, G, B from the pixel's centre for each cell of the pattern, metres, y up.
    std::vector<std::array<glm::dvec2, 3>> offsetsM;
    bool upsideDown = false; ///< row 0 is the lowest

    [[nodiscard]] std::size_t cellAt(int x, int y) const {
        return static_cast<std::size_t>(cellOf(pattern, x, height - 1 - y));
    }
    /// Pixel's centre; column x, row y of the panel's picture.
    [[nodiscard]] glm::dvec2 centre(int x, int y) const {
        const double down = upsideDown ? height - 1 - y : y;
        return {(x + 0.5 - width / 2.0) * pixelM, (height / 2.0 - 0.5 - down) * pixelM};
    }
    [[nodiscard]] glm::dvec2 position(int x, int y, int c) const {
        return centre(x, y) + offsetsM[cellAt(x, y)][static_cast<std::size_t>(c)];
    }
};

/// Nothing for displays without optics: frame formats and colour filters, whose pixels count as
/// one place. An RGB stripe where the maker's formula has no more to say.
[[nodiscard]] std::optional<SubpixelLayout> subpixelLayout(const DisplayProfile& display);

/// A display's phase grid as the correction of its lenses' coordinate, which rises along x where a
/// law's phase may fall, from the panel's upper edge, where row 0 may be the lowest; and back.
[[nodiscard]] PhaseGrid turnedGrid(const DisplayProfile& display, PhaseGrid grid);

struct DisplayOptics {
    LensArray lenses;
    SubpixelLayout subpixels;
};

/// Nothing for displays without optics, or whose optics are not known: frame formats, LUTs, and
/// tables of views without a gap or that no regular lens makes.
///
/// Lens axes: seen from (0, 0, D) they lie on the panel where the maker's phase is 1/2, the middle
/// of the fan; the lens plane has that pattern scaled by 1 - gap/D. Gap: as given, else one
/// lens fans out over the cone: gap = pitch / (2 tan(cone/2)). A line screen is where its numbers
/// say (Kooima 2007, section 2.1); slit centres at phase (1 + c)/2, 1 - c wide.
/// TrackedLens: an axis is amid the lit band, and the gap is the one which moves the seen point by
/// as much as the law does per metre of an eye at (0, 0, D).
[[nodiscard]] std::optional<DisplayOptics> displayOptics(const DisplayProfile& display);

} // namespace autostereo::calib

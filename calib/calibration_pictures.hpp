#pragma once

#include "calib/optics.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

// What a display shows while its optics are measured from photographs: a chessboard, which says
// where the camera stands, and fringes in three steps, which say where the lenses are.

namespace autostereo::calib {

/// A chessboard over the whole panel, the same in every view. Inner corners in rows from the upper
/// left as the panel hangs, an odd number across and an even one down, so that no half turn maps
/// the board to itself.
struct PanelBoard {
    explicit PanelBoard(const SubpixelLayout& panel);

    int columns;
    int rows;
    std::vector<glm::dvec2> cornersM; ///< display space, z = 0

    /// Of the panel's size, R, G, B, top row first.
    [[nodiscard]] std::vector<std::uint8_t> picture() const;

  private:
    int width_, height_;
    int square_; ///< pixels
    int left_, top_;
};

/// A cosine of each sub-pixel's phase under an assumed display, plus a few cycles over the panel
/// (fringes would otherwise be too broad to follow). What a camera sees of it is a moiré between
/// the assumed lenses and the real ones: seen from e, a point of the panel lies on a real axis, so
/// the fringes' phase there is how far the assumed lenses are off.
class Fringes {
  public:
    static constexpr int kSteps = 3; ///< pictures, a third of a cycle apart

    /// Nothing for displays whose optics are not known.
    [[nodiscard]] static std::optional<Fringes> of(const DisplayProfile& assumed);

    /// At a point of the panel (metres); linear.
    [[nodiscard]] double cycles(const glm::dvec2& panelPoint) const;
    /// sRGB levels of a cosine in light; of the panel's size, R, G, B, top row first.
    [[nodiscard]] std::vector<std::uint8_t> picture(int step) const;

  private:
    Fringes(DisplayOptics assumed, const DisplayProfile& display);

    DisplayOptics assumed_;
    glm::dvec3 nominalEye_;
    glm::dvec2 panelM_;
};

enum class CalibrationPicture { Board, Fringes1, Fringes2, Fringes3 };

/// Of the panel's size, R, G, B, top row first; nothing for displays whose optics are not known.
[[nodiscard]] std::optional<std::vector<std::uint8_t>>
calibrationPicture(CalibrationPicture picture, const DisplayProfile& assumed);

} // namespace autostereo::calib

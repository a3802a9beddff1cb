#pragma once

#include "calib/lens_light.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace autostereo::calib {

/// What an eye sees of a panel through its optics.
struct EyePicture {
    std::vector<std::uint8_t> rgb; ///< of the panel's size, as the eye sees it: top row first
    std::size_t lit = 0;           ///< sub-pixels that the eye sees anything of
    double meanShare = 0;          ///< seen share of a sub-pixel, mean over the panel
};

/// `panel`: width x height x 3, sRGB, as it is sent to the display. Light adds up linearly: sRGB ->
/// linear, mean of the seen sub-pixels of each colour, -> sRGB. The mean's weights are what the
/// eye sees of each times a tent one lens period wide and as many rows high as the axes take to
/// move by one pixel (half maximum); wider where that finds no light. Nothing of a colour
/// anywhere is black. Pure; reentrant; time grows with the number of sub-pixels only, memory is 20
/// bytes a pixel. Throws std::invalid_argument where `panel` has another size or the eye is not in
/// front of panel and lenses.
[[nodiscard]] EyePicture look(const DisplayOptics& optics, const LightModel& light,
                              const glm::dvec3& eye, std::span<const std::uint8_t> panel);

} // namespace autostereo::calib

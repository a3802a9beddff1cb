#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace autostereo::devices {

/// Borrowed 8-bit grey pixels, rows tightly packed, top row first.
struct GreyView {
    std::span<const std::uint8_t> pixels; ///< width * height
    int width = 0, height = 0;
};

/// Where a viewer's pupils are seen, pixels.
struct PupilPair {
    glm::dvec2 left, right; ///< their own left one is on the picture's right
};

/// The middle of an iris of that radius (pixels, 3 to 10 are of use): where the means of gradients
/// (Timm and Barth 2011, eq. 2 to 4) are largest, gradients counted at about the iris' radius only,
/// dark middles preferred (eq. 5); then to a part of a pixel where the lines along these gradients
/// meet (Parthasarathy 2012). Nothing: a picture without an edge, or one that is smaller than the
/// iris. Reentrant.
[[nodiscard]] std::optional<glm::dvec2> pupilCentre(const GreyView& eye, double irisRadius);

} // namespace autostereo::devices

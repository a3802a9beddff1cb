#pragma once

#include "gpu/readback.hpp"
#include "tests/oracle/display_oracle.hpp"

#include <array>
#include <cstdint>

// Slow, obvious twin of what fills a tracked barrier's panel: for each sub-pixel, which eyes see
// it, in extended precision.

namespace autostereo::oracle {

/// Whether a barrier's sub-pixel is lit for an eye: between two lines, less the guard bands.
inline bool isLit(const calib::DisplayProfile& display, const glm::dvec3& eye, int x, int y,
                  int c) {
    const auto& screen = std::get<calib::LineScreen>(display.law);
    const Real phase = fraction(lineScreen(screen, display, eye, x, y, c));
    const Real half = static_cast<Real>(screen.guard) / 2;
    // A guard band below 0 reaches over the end of the cycle.
    return (phase >= screen.dutyCycle + half && phase < 1 - half) || phase < -half;
}

/// How a pixel's colours are shared out among the eyes. Subpixels: each to those that see it
/// (Kooima 2007, section 3.5). Pixels: all to those that see its middle. LeftFirst: as Subpixels,
/// but the right eye gets none of a pixel that shows the left eye any.
enum class Sharing { Subpixels, Pixels, LeftFirst };

/// Each eye's picture of the panel's size -> the panel: the brighter where both see a sub-pixel.
inline gpu::RgbImage interleaved(const calib::DisplayProfile& display,
                                 const std::array<glm::dvec3, 2>& eyes,
                                 const std::array<gpu::RgbImage, 2>& views, Sharing sharing) {
    gpu::RgbImage panel{display.width, display.height, {}};
    panel.pixels.reserve(views[0].pixels.size());
    for (int y = 0; y < display.height; ++y)
        for (int x = 0; x < display.width; ++x) {
            bool isLeft = false;
            for (int c = 0; c < 3; ++c)
                isLeft = isLeft || isLit(display, eyes[0], x, y, c);
            for (int c = 0; c < 3; ++c) {
                std::uint8_t level = 0;
                for (std::size_t eye = 0; eye < 2; ++eye) {
                    if (eye == 1 && isLeft && sharing == Sharing::LeftFirst) continue;
                    if (isLit(display, eyes.at(eye), x, y, sharing == Sharing::Pixels ? 1 : c))
                        level = std::max(level, views.at(eye).pixels[panel.pixels.size()]);
                }
                panel.pixels.push_back(level);
            }
        }
    return panel;
}

} // namespace autostereo::oracle

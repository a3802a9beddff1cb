#pragma once

#include "calib/display_profile.hpp"
#include "calib/phase_tables.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace autostereo::calib {

/// Sub-pixel -> the eyes that it is lit for, for barriers and lenses that follow their viewers'
/// eyes (the Combiner of Kooima 2007). View i is what eye i sees; where bands overlap the brighter
/// view wins. Value type; reentrant.
struct BandMap {
    std::vector<PhaseTables> eyes; ///< left to right
    std::uint32_t start = 0;       ///< lit where phase - start < width, wrapping
    std::uint32_t width = 0;
    std::optional<Waveform> waveform; ///< in place of the sharp band

    [[nodiscard]] bool lit(std::size_t eye, int x, int y, int c) const {
        return eyes[eye].phase(x, y, c) - start < width;
    }
};

/// Line screen phase of an eye (display space, metres, in front of the barrier) as an affine law.
[[nodiscard]] LinearPhase lineScreenPhase(const LineScreen& screen, const DisplayProfile& display,
                                          int width, int height, const glm::dvec3& eye);
[[nodiscard]] LinearPhase trackedLensPhase(const TrackedLens& lens, const glm::dvec3& eye);

/// The display's views as eyes in their nominal places, left to right: display space, metres.
[[nodiscard]] std::vector<glm::dvec3> nominalEyes(const DisplayProfile& display);

/// Eyes as given; none: the file's own, else the display's views in their nominal places.
[[nodiscard]] BandMap bandMap(const DisplayProfile& display, int width, int height,
                              const std::vector<glm::dvec3>& eyes);

} // namespace autostereo::calib

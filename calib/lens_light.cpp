#include "calib/lens_light.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace autostereo::calib {

namespace {

/// A line on the border of two sub-pixels, up to rounding (some 1e-12 of a cycle with thousands of
/// lenses), counts as this much farther right.
constexpr double kTie = 1e-9;

/// Share of a box `width` wide at `centre`, cycles, within the apertures around whole numbers.
double shareInside(double centre, double width, double aperture) {
    const double away = centre - std::round(centre);
    const double half = width / 2;
    if (aperture == 0) return away - kTie >= -half && away - kTie < half ? 1 : 0;
    double inside = 0;
    for (const double axis : {-1.0, 0.0, 1.0}) // a wide box reaches the neighbours
        inside += std::max(0.0, std::min(away + half, axis + aperture / 2) -
                                    std::max(away - half, axis - aperture / 2));
    return std::min(1.0, inside / width);
}

using Order = std::array<std::size_t, 3>;

/// R, G, B of each cell from left to right.
std::vector<Order> leftToRight(const SubpixelLayout& layout) {
    std::vector<Order> orders;
    for (const auto& offsets : layout.offsetsM) {
        Order& order = orders.emplace_back(Order{0, 1, 2});
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return offsets[a].x < offsets[b].x; });
    }
    return orders;
}

/// What an eye sees of a sub-pixel is partly the light of its neighbours, and theirs partly its.
void leak(const SubpixelLayout& layout, double crosstalk, int y, std::span<double> shares) {
    const auto orders = leftToRight(layout);
    std::vector<std::size_t> places(shares.size());
    for (std::size_t x = 0; x < places.size() / 3; ++x)
        for (std::size_t i = 0; i < 3; ++i)
            places[3 * x + i] = 3 * x + orders[layout.cellAt(static_cast<int>(x), y)][i];
    double before = shares[places.front()]; // the row goes on like its last sub-pixel
    for (std::size_t i = 0; i < places.size(); ++i) {
        double& share = shares[places[i]];
        const double own = share;
        const double after = i + 1 < places.size() ? shares[places[i + 1]] : own;
        share = (1 - 2 * crosstalk) * own + crosstalk * (before + after);
        before = own;
    }
}

} // namespace

void seenShares(const DisplayOptics& optics, const LightModel& light, const glm::dvec3& eye, int y,
                std::span<double> shares) {
    const SubpixelLayout& layout = optics.subpixels;
    const double width = layout.pixelM / 3 * optics.lenses.cyclesPerM(eye.z);
    std::size_t at = 0;
    for (int x = 0; x < layout.width; ++x)
        for (int c = 0; c < 3; ++c)
            shares[at++] = shareInside(optics.lenses.coordinate(eye, layout.position(x, y, c)),
                                       width, light.aperture);
    if (light.crosstalk > 0) leak(layout, light.crosstalk, y, shares);
}

} // namespace autostereo::calib

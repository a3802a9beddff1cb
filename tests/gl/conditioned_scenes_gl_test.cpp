// What conditioning is worth on simulated time-of-flight pictures, against their exact depth.

#include "tests/gl/conditioner_support.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cstdio>

namespace autostereo::test {
namespace {

class ConditionedScenesGlTest : public GlTest {};

double sigmaCounts(const DepthShot& exact, std::size_t pixel) {
    return 1e3 * devices::sim::tofSigmaM(exact.amplitude[pixel]);
}

/// How far a measurement may be off before it is no measurement of its own surface.
double tolerance(const DepthShot& exact, std::size_t pixel) {
    return std::max(6 * sigmaCounts(exact, pixel), 0.02 * exact.counts[pixel]);
}

/// Off its own surface and strictly between it and one that its footprint reaches.
bool isFlying(const DepthShot& exact, const DepthShot& noisy, int x, int y) {
    const std::size_t own = exact.at(x, y);
    const int count = noisy.counts[own], truth = exact.counts[own];
    if (std::abs(count - truth) <= tolerance(exact, own)) return false;
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
        if (x + dx < 0 || y + dy < 0 || x + dx >= exact.width || y + dy >= exact.height) continue;
        const int other = exact.counts[exact.at(x + dx, y + dy)];
        if (other > 0 && (count - truth) * (count - other) < 0) return true;
    }
    return false;
}

struct Removal {
    std::size_t flying = 0, flyingRemoved = 0, good = 0, goodRemoved = 0;

    static double percent(std::size_t part, std::size_t all) {
        return 100.0 * static_cast<double>(part) / static_cast<double>(all);
    }
    [[nodiscard]] double flyingPct() const { return percent(flyingRemoved, flying); }
    [[nodiscard]] double goodPct() const { return percent(goodRemoved, good); }
};

Removal removalOf(const std::string& scene, const std::string& size, int frames) {
    const std::string uri = "sim:" + scene + "?color=64x36&depth=" + size;
    Shots noisyShots(uri), exactShots(uri + "&noise=off");
    gpu::ConditionParams params;
    params.hold = params.fillHoles = false;
    Conditioned conditioned(params, noisyShots.camera());
    Removal found;
    for (int frame = 0; frame < frames; ++frame) {
        const DepthShot noisy = noisyShots.next(), exact = exactShots.next();
        const auto clean = conditioned(noisy);
        for (int y = 0; y < noisy.height; ++y)
            for (int x = 0; x < noisy.width; ++x) {
                const std::size_t pixel = noisy.at(x, y);
                if (noisy.counts[pixel] == 0 || noisy.counts[pixel] == 65535) continue;
                const bool removed = clean[pixel] == 0;
                if (isFlying(exact, noisy, x, y)) {
                    ++found.flying;
                    found.flyingRemoved += removed ? 1 : 0;
                } else if (std::abs(noisy.counts[pixel] - exact.counts[pixel]) <=
                           tolerance(exact, pixel)) {
                    ++found.good;
                    found.goodRemoved += removed ? 1 : 0;
                }
            }
    }
    return found;
}

TEST_F(ConditionedScenesGlTest, FlyingPixelsGoAndGoodOnesStay) {
    for (const char* scene : {"room", "person", "calibration-board"})
        for (const char* size : {"176x144", "320x288", "640x576"}) {
            const Removal found = removalOf(scene, size, 5);
            std::printf("%s %s: %zu flying, %.2f %% removed; %zu good, %.3f %% lost\n", scene, size,
                        found.flying, found.flyingPct(), found.good, found.goodPct());
            EXPECT_GE(found.flyingPct(), 98) << scene << ' ' << size;
            EXPECT_LE(found.goodPct(), 1) << scene << ' ' << size;
        }
}

} // namespace
} // namespace autostereo::test

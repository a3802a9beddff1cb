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

bool isAtEdge(const DepthShot& exact, int x, int y) {
    const int own = exact.counts[exact.at(x, y)];
    for (int j = std::max(0, y - 1); j <= std::min(exact.height - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(exact.width - 1, x + 1); ++i)
            if (std::abs(exact.counts[exact.at(i, j)] - own) > 0.04 * own) return true;
    return false;
}

/// After settling, 300 noisy frames of a still room. At edges a pixel is a mixture in every third
/// frame, and about the weakest amplitude it is missing in every second; those may change.
TEST_F(ConditionedScenesGlTest, StillPixelsStayExactlyConstant) {
    const std::string uri = "sim:room?color=64x36&depth=176x144";
    Shots shots(uri), exactShots(uri + "&noise=off");
    const DepthShot exact = exactShots.next();
    Conditioned conditioned({}, shots.camera());
    std::vector<std::uint16_t> last;
    std::vector<bool> changed(exact.counts.size());
    std::size_t changes = 0, still = 0, stillChanged = 0;
    constexpr int kSettling = 40, kFrames = 300;
    for (int frame = 0; frame < kSettling + kFrames; ++frame) {
        const auto clean = conditioned(shots.next());
        for (std::size_t i = 0; frame > kSettling && i < clean.size(); ++i)
            if (clean[i] != last[i]) {
                changed[i] = true;
                ++changes;
            }
        last = clean;
    }
    for (int y = 0; y < exact.height; ++y)
        for (int x = 0; x < exact.width; ++x) {
            const std::size_t pixel = exact.at(x, y);
            if (exact.counts[pixel] == 0 || exact.amplitude[pixel] < 50 || isAtEdge(exact, x, y))
                continue;
            ++still;
            stillChanged += changed[pixel] ? 1 : 0;
        }
    const double perFrame = Removal::percent(changes, kFrames * exact.counts.size());
    std::printf("still: %zu of %zu pixels changed ever; of all, %.3f %% change in a frame\n",
                stillChanged, still, perFrame);
    EXPECT_LE(Removal::percent(stillChanged, still), 0.1);
    EXPECT_LE(perFrame, 0.3);
}

/// A wall whose distance is given for each frame, 600 counts bright: sigma 5.4 mm, gate 27 mm.
class Wall {
  public:
    DepthShot at(double depthM) {
        const std::vector<devices::sim::TofSample> exact(kWidth * kHeight,
                                                         {static_cast<float>(depthM), 600.0F});
        DepthShot shot{kWidth, kHeight, std::vector<std::uint16_t>(exact.size()),
                       std::vector<std::uint16_t>(exact.size())};
        sensor_.measure(exact, ++frame_, shot.counts, shot.amplitude);
        return shot;
    }
    static constexpr int kWidth = 96, kHeight = 80;
    static constexpr double kGateMm = 27;
    static calib::CameraModel camera() {
        return devices::sim::simulatedRig(kWidth, kHeight, 64, 36).depth;
    }

  private:
    devices::sim::TofSensor sensor_{kWidth, kHeight, 5, true};
    std::uint64_t frame_ = 0;
};

TEST_F(ConditionedScenesGlTest, AStepPassesAtOnce) {
    Wall wall;
    Conditioned conditioned({}, Wall::camera());
    for (int frame = 0; frame < 40; ++frame)
        (void)conditioned(wall.at(2));
    const DepthShot stepped = wall.at(2.06); // the gate and the most that noise takes off
    EXPECT_EQ(conditioned(stepped), stepped.counts);
}

/// A quarter gate per frame: nowhere more than the gate and the noise behind, from the start on and
/// for as long as it lasts; and no worse than any still picture some frames after.
TEST_F(ConditionedScenesGlTest, ARampIsFollowed) {
    Wall wall;
    Conditioned conditioned({}, Wall::camera());
    double depth = 2;
    for (int frame = 0; frame < 40; ++frame)
        (void)conditioned(wall.at(depth));
    const auto errorOf = [&](const std::vector<std::uint16_t>& clean) {
        double sum = 0, most = 0;
        for (const std::uint16_t count : clean) {
            sum += std::abs(count - 1000 * depth);
            most = std::max(most, std::abs(count - 1000 * depth));
        }
        return std::pair{sum / static_cast<double>(clean.size()), most};
    };
    double mean = 0, most = 0;
    for (int frame = 1; frame <= 24; ++frame) {
        depth += Wall::kGateMm / 4 * 1e-3;
        const auto [meanNow, mostNow] = errorOf(conditioned(wall.at(depth)));
        if (frame < 8) continue;
        mean = std::max(mean, meanNow);
        most = std::max(most, mostNow);
    }
    for (int frame = 0; frame < 40; ++frame)
        (void)conditioned(wall.at(depth));
    const double after = errorOf(conditioned(wall.at(depth))).first;
    std::printf("ramp: mean error %.1f mm, most %.1f mm; then %.2f mm\n", mean, most, after);
    EXPECT_LE(mean, Wall::kGateMm / 2);
    EXPECT_LE(most, 2.5 * Wall::kGateMm);
    EXPECT_LE(after, 2);
}

/// A hand, 12 cm wide at 0.6 m, goes across a wall at 1.5 m with 1 m/s: 12 pixels a frame.
DepthShot handAt(int frame, double* left) {
    constexpr int kWidth = 320, kHeight = 64;
    *left = 10 + 11.6 * frame;
    DepthShot shot{kWidth, kHeight, {}, {}};
    for (int i = 0; i < kWidth * kHeight; ++i) {
        const bool isHand = i % kWidth >= *left && i % kWidth < *left + 41 && i / kWidth > 10;
        const double z = isHand ? 0.6 : 1.5;
        shot.counts.push_back(static_cast<std::uint16_t>(1000 * z));
        shot.amplitude.push_back(static_cast<std::uint16_t>(devices::sim::tofAmplitude(0.6, 1, z)));
    }
    return shot;
}

/// Pixels that the hand's edge passed in the last frame but one are as good as after any single
/// measurement.
TEST_F(ConditionedScenesGlTest, AHandLeavesNoTrail) {
    const devices::sim::TofSensor sensor(320, 64, 5, true);
    Conditioned conditioned({}, devices::sim::simulatedRig(320, 64, 64, 36).depth);
    double left = 0, error = 0, noise = 0;
    std::size_t passed = 0, off = 0;
    DepthShot before;
    for (int frame = -30; frame < 22; ++frame) {
        const DepthShot exact = handAt(std::max(frame, 0), &left);
        std::vector<devices::sim::TofSample> samples;
        for (std::size_t i = 0; i < exact.counts.size(); ++i)
            samples.push_back({static_cast<float>(exact.counts[i]) * 1e-3F,
                               static_cast<float>(exact.amplitude[i])});
        DepthShot shot = exact;
        sensor.measure(samples, static_cast<std::uint64_t>(frame + 100), shot.counts,
                       shot.amplitude);
        const auto clean = conditioned(shot);
        const DepthShot twoAgo = handAt(std::max(frame - 2, 0), &left),
                        oneAgo = handAt(std::max(frame - 1, 0), &left);
        for (std::size_t i = 0; frame > 2 && i < clean.size(); ++i) {
            const int x = static_cast<int>(i) % 320, y = static_cast<int>(i) / 320;
            const bool isPassed =
                oneAgo.counts[i] == exact.counts[i] && twoAgo.counts[i] != exact.counts[i];
            if (!isPassed || isAtEdge(exact, x, y)) continue;
            ++passed;
            error += std::abs(clean[i] - exact.counts[i]);
            noise += std::abs(shot.counts[i] - exact.counts[i]);
            off += std::abs(clean[i] - exact.counts[i]) > tolerance(exact, i) ? 1 : 0;
        }
    }
    const auto count = static_cast<double>(passed);
    std::printf("hand: %zu pixels passed, mean error %.2f mm (one measurement: %.2f), %zu off\n",
                passed, error / count, noise / count, off);
    EXPECT_GT(passed, 10000U);
    EXPECT_LE(error, noise);
    EXPECT_EQ(off, 0U);
}

} // namespace
} // namespace autostereo::test

// The conditioner's passes against their oracle, bit for bit: all of it is whole numbers.

#include "tests/gl/conditioner_support.hpp"
#include "tests/oracle/conditioner_oracle.hpp"
#include "tests/support/gl_fixture.hpp"

#include <array>
#include <random>

namespace autostereo::test {
namespace {

class DepthConditionerGlTest : public GlTest {
  protected:
    /// A camera for any grid, 75 degrees wide.
    static calib::CameraModel camera(int width, int height) {
        return devices::sim::simulatedRig(width, height, 64, 36).depth;
    }
    static std::size_t differences(const std::vector<std::uint16_t>& a,
                                   const std::vector<std::uint16_t>& b) {
        std::size_t count = a.size() == b.size() ? 0 : a.size();
        for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
            count += a[i] != b[i] ? 1 : 0;
        return count;
    }
    static gpu::ConditionParams nothing() {
        gpu::ConditionParams params;
        params.validity = params.confidence = params.flyingPixels = params.hold = params.fillHoles =
            false;
        return params;
    }
};

constexpr std::array<std::uint16_t, 12> kValues{0,    1,    149,  150,   151,   1000,
                                                1003, 1040, 2000, 10000, 65000, 65535};

DepthShot randomShot(int width, int height, std::mt19937& random, bool amplitude) {
    DepthShot shot{width, height, {}, {}};
    const std::uint16_t likely = kValues[random() % kValues.size()];
    for (int i = 0; i < width * height; ++i) {
        shot.counts.push_back(random() % 3 == 0 ? kValues[random() % kValues.size()] : likely);
        if (amplitude)
            shot.amplitude.push_back(static_cast<std::uint16_t>(random() >> (16 + random() % 16)));
    }
    return shot;
}

TEST_F(DepthConditionerGlTest, SimulatedFramesAgreeWithTheOracle) {
    for (const char* scene : {"room", "person"})
        for (const auto& [size, frames] : {std::pair{"176x144", 40}, {"320x288", 20}}) {
            Shots shots(std::string("sim:") + scene + "?color=64x36&depth=" + size);
            Conditioned conditioned({}, shots.camera());
            std::optional<oracle::Conditioner> truth;
            for (int frame = 0; frame < frames; ++frame) {
                const DepthShot shot = shots.next();
                if (!truth)
                    truth.emplace(gpu::ConditionParams{}, gpu::DepthMeshParams{}, shots.camera(),
                                  shot.width, shot.height);
                ASSERT_EQ(differences(conditioned(shot), (*truth)(shot.counts, shot.amplitude)), 0U)
                    << scene << ' ' << size << " frame " << frame;
            }
        }
}

/// All kinds of values, grids down to one pixel, every step alone and all together, with amplitudes
/// and without, for as long as settling, holding and keeping take.
TEST_F(DepthConditionerGlTest, AnyValuesAgreeWithTheOracle) {
    std::mt19937 random(3);
    constexpr std::array<std::array<int, 2>, 6> kSizes{
        {{1, 1}, {1, 9}, {9, 1}, {2, 2}, {17, 16}, {37, 23}}};
    for (unsigned steps = 0; steps < 32; ++steps) {
        gpu::ConditionParams params = nothing();
        params.validity = (steps & 1U) != 0;
        params.confidence = (steps & 2U) != 0;
        params.flyingPixels = (steps & 4U) != 0;
        params.hold = (steps & 8U) != 0;
        params.fillHoles = (steps & 16U) != 0;
        params.holeWidth = static_cast<int>(random() % 9);
        params.settleFrames = 1 + static_cast<int>(random() % 5);
        params.keepFrames = static_cast<int>(random() % 4);
        params.gateSigmas = 1 + static_cast<double>(random() % 8) / 2;
        for (const auto& [width, height] : kSizes) {
            Conditioned conditioned(params, camera(width, height));
            oracle::Conditioner truth(params, {}, camera(width, height), width, height);
            for (int frame = 0; frame < 10; ++frame) {
                const DepthShot shot = randomShot(width, height, random, random() % 4 != 0);
                ASSERT_EQ(differences(conditioned(shot), truth(shot.counts, shot.amplitude)), 0U)
                    << width << 'x' << height << " frame " << frame << " steps " << steps;
            }
        }
    }
}

TEST_F(DepthConditionerGlTest, WithAllStepsOffOnlyNoMeasurementIsMapped) {
    std::mt19937 random(4);
    const DepthShot shot = randomShot(37, 23, random, true);
    Conditioned conditioned(nothing(), camera(37, 23));
    const auto clean = conditioned(shot);
    for (std::size_t i = 0; i < clean.size(); ++i)
        ASSERT_EQ(clean[i], shot.counts[i] == 65535 ? 0 : shot.counts[i]);
}

TEST_F(DepthConditionerGlTest, PixelClasses) {
    constexpr int kWidth = 21, kHeight = 18;
    const auto shotOf = [](auto valueAt) {
        DepthShot shot{kWidth, kHeight, {}, {}};
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                shot.counts.push_back(static_cast<std::uint16_t>(valueAt(x, y)));
        return shot;
    };
    const auto clean = [&](const DepthShot& shot) {
        return Conditioned({}, camera(kWidth, kHeight))(shot);
    };
    const std::vector<std::uint16_t> none(kWidth * kHeight);
    for (const int count : {0, 65535, 1}) // none, none, 1 mm
        EXPECT_EQ(clean(shotOf([&](int, int) { return count; })), none) << count;
    const DepthShot far = shotOf([](int, int) { return 65000; });
    EXPECT_EQ(clean(far), far.counts) << "within the range";
    const DepthShot one = shotOf([](int x, int y) { return x == 9 && y == 7 ? 1234 : 0; });
    EXPECT_EQ(clean(one), one.counts) << "nothing to be filled from";
    const DepthShot board = shotOf([](int x, int y) { return (x + y) % 2 == 0 ? 1234 : 65535; });
    const auto closed = clean(board);
    for (int i = 0; i < kWidth * kHeight; ++i) {
        const bool isCorner = i % kWidth % (kWidth - 1) == 0 && i / kWidth % (kHeight - 1) == 0;
        if (!isCorner) {
            ASSERT_EQ(closed[static_cast<std::size_t>(i)], 1234) << "one pixel wide";
        }
    }
}

/// In a hole between two surfaces there is the one or the other; a hole in a slope goes on with it.
TEST_F(DepthConditionerGlTest, HolesAreFilledWithoutBridgingSurfaces) {
    constexpr int kWidth = 32, kHeight = 6;
    gpu::ConditionParams params;
    params.holeWidth = 3;
    const auto filled = [&](int from, int to, auto surface) {
        DepthShot shot{kWidth, kHeight, {}, {}};
        for (int i = 0; i < kWidth * kHeight; ++i) {
            const int x = i % kWidth;
            shot.counts.push_back(
                static_cast<std::uint16_t>(x >= from && x <= to ? 0 : surface(x)));
        }
        return Conditioned(params, camera(320, 60))(shot);
    };
    const auto step = [](int x) { return x <= 10 ? 1000 : 2000; };
    const auto slope = [](int x) { return 1000 + 10 * x; };
    const auto edge = filled(10, 12, step), ramp = filled(10, 12, slope),
               wide = filled(10, 13, slope);
    for (int i = 0; i < kWidth * kHeight; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const int x = i % kWidth;
        const bool inside = x >= 10 && x <= 12;
        ASSERT_EQ(edge[at], inside ? 2000 : step(x)) << "the farther one goes on";
        ASSERT_EQ(ramp[at], slope(x));
        ASSERT_EQ(wide[at], x >= 10 && x <= 13 ? 0 : slope(x)) << "too wide";
    }
}

TEST_F(DepthConditionerGlTest, AnotherSizeOrUnitStartsAnew) {
    const auto wall = [](int width, int height, int count) {
        return DepthShot{width,
                         height,
                         std::vector<std::uint16_t>(static_cast<std::size_t>(width * height),
                                                    static_cast<std::uint16_t>(count)),
                         {}};
    };
    Conditioned conditioned({}, camera(20, 16));
    for (int frame = 0; frame < 30; ++frame)
        ASSERT_EQ(conditioned(wall(20, 16, 1000))[0], 1000);
    EXPECT_EQ(conditioned(wall(20, 16, 1002))[0], 1000) << "held";
    EXPECT_EQ(conditioned(wall(24, 16, 1002))[0], 1002) << "new size";
    EXPECT_EQ(conditioned(wall(24, 16, 1004), 0.0005)[0], 1004) << "new unit";
}

TEST_F(DepthConditionerGlTest, TalliesArriveAndAddUp) {
    Shots shots("sim:room?color=64x36&depth=176x144");
    Conditioned conditioned({}, shots.camera());
    for (int frame = 0; frame < 30; ++frame)
        (void)conditioned(shots.next());
    const gpu::DepthConditioner::Tally& tally = conditioned.pass().tally();
    const auto pixels = [&](const std::string& what) {
        const auto& names = gpu::DepthConditioner::kTallies;
        return tally.pixels.at(
            static_cast<std::size_t>(std::find(names.begin(), names.end(), what) - names.begin()));
    };
    EXPECT_GE(tally.frames, 20U);
    EXPECT_GT(pixels("flying"), 100 * tally.frames);
    EXPECT_GT(pixels("settling"), 16 * 20000U);
    EXPECT_GT(pixels("held"), (tally.frames - 17) * 20000);
    EXPECT_LE(pixels("held"), tally.frames * 176 * 144);
    EXPECT_GT(pixels("kept"), 0U);
}

} // namespace
} // namespace autostereo::test

// Every sub-pixel of every shipped display, at its full size, with its own views and with 100: the
// host's view is the one of the published formula in extended precision, the GPU's is the host's.

#include "calib/phase_laws.hpp"
#include "config/load.hpp"
#include "tests/gl/numbered_views.hpp"
#include "tests/oracle/display_oracle.hpp"
#include "tests/support/data.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cctype>
#include <cmath>
#include <cstdio>

namespace autostereo::test {
namespace {

using oracle::Real;

/// Two roundings to 2^-32 cycle, and 2^-49 for every column and row (16,384 of each: 2^-34); the
/// coefficients are carried in double until there, up to 1e-12 cycle.
const Real kPhaseBound = std::ldexp(Real{1}, -32) + std::ldexp(Real{1}, -34) + Real{1e-12};
/// A difference of views is the rounding's only within this distance of a boundary, cycles.
const Real kTieBound = std::ldexp(Real{1}, -31);
constexpr int kManyViews = 100;

struct Agreement {
    std::size_t subpixels = 0;
    std::size_t differences = 0;
    std::size_t ties = 0; ///< within the tie bound of a boundary
    Real largestError = 0;
    Real farthestDifference = 0; ///< from a boundary
};

Agreement compare(const calib::DisplayProfile& display, const calib::ViewMap& map, int step) {
    const oracle::PhaseFunction formula = oracle::phaseFunction(display);
    Agreement result;
    const int views = oracle::vendorViews(display);
    for (int y = 0; y < map.tables.height; y += step)
        for (int x = 0; x < map.tables.width; ++x)
            for (int c = 0; c < 3; ++c) {
                ++result.subpixels;
                const Real phase = formula(x, y, c);
                const std::uint32_t fixed = map.phase(x, y, c);
                Real error = std::abs(static_cast<Real>(fixed) * 0x1p-32L - phase);
                if (error > Real{0.5}) error = 1 - error;
                if (error > result.largestError) result.largestError = error;
                const Real away = oracle::toBoundary(phase, views);
                if (away < kTieBound) ++result.ties;
                const auto shown = map.view(fixed);
                const int view = shown == calib::ViewMap::kBlack ? -1 : static_cast<int>(shown);
                if (view == oracle::viewOf(display, phase)) continue;
                ++result.differences;
                result.farthestDifference = std::max(result.farthestDifference, away);
            }
    return result;
}

/// Views of which no sub-pixel lies on a boundary: they must agree without exception.
bool isRational(const calib::DisplayProfile& display) {
    const auto* lens = std::get_if<calib::VanBerkelLens>(&display.law);
    return std::holds_alternative<calib::ViewTable>(display.law) ||
           (lens != nullptr && oracle::halfStep(*lens, display.views) > 0);
}

void expectAgreement(const calib::DisplayProfile& display, const calib::ViewMap& map,
                     int step = 1) {
    const Agreement result = compare(display, map, step);
    EXPECT_LE(result.largestError, kPhaseBound);
    EXPECT_LE(result.farthestDifference, kTieBound);
    // By chance 2^-30 N of all sub-pixels lie so close to one of N boundaries; where a template's
    // numbers are round some lie on one exactly, and extended precision's last bit decides for it.
    EXPECT_LE(static_cast<double>(result.differences),
              2e-5 * static_cast<double>(result.subpixels));
    if (isRational(display)) {
        EXPECT_EQ(result.differences, 0U);
        EXPECT_EQ(result.ties, 0U);
    }
    std::printf("%s %dx%d, %d views: %zu of %zu differ, %zu ties, phase error %.2Lf x 2^-32\n",
                display.name.c_str(), map.tables.width, map.tables.height, display.views,
                result.differences, result.subpixels, result.ties, result.largestError * 0x1p32L);
}

class ShippedDisplays : public GlTest, public testing::WithParamInterface<std::string> {
  protected:
    static calib::DisplayProfile profile() {
        calib::DisplayProfile display = config::loadDisplay(GetParam());
        if (display.width == 0) display.width = 640, display.height = 360;
        return display;
    }
    template<class Map>
    static void expectShown(const calib::DisplayProfile& display, const Map& map,
                            gpu::TileFilter filter) {
        const auto image = interleaved(map, display.width, display.height, display.views,
                                       {filter, gpu::ViewFilter::Nearest, 0});
        EXPECT_EQ(differences(image, [&](int x, int y, int c) { return levelOf(map, x, y, c); }),
                  0U);
    }
};
class DisplaysWithPhase : public ShippedDisplays {};
class DisplaysWithLens : public ShippedDisplays {};
class DisplaysWithBands : public ShippedDisplays {};

/// Every sub-pixel of large panels takes seconds: with its own views every third row, in full runs
/// and with a hundred views all of them.
TEST_P(DisplaysWithPhase, SubpixelsShowTheFormulasView) {
    const calib::DisplayProfile display = profile();
    const auto map = calib::makeViewMap(display, display.width, display.height);
    const bool whole = fullCampaign() || display.width * display.height < 4'000'000;
    expectAgreement(display, map, whole ? 1 : 3);
    expectShown(display, map, gpu::TileFilter::Linear);
}

TEST_P(DisplaysWithLens, EverySubpixelDoesWithAHundredViews) {
    calib::DisplayProfile display = profile();
    display.views = kManyViews;
    const calib::ViewMap map = calib::makeViewMap(display, display.width, display.height);
    expectAgreement(display, map);
    expectShown(display, map, gpu::TileFilter::Nearest);
}

TEST_P(DisplaysWithBands, AreLitWhereTheFormulaSays) {
    const calib::DisplayProfile display = profile();
    const std::vector<glm::dvec3> eyes{{-0.04, 0.11, 0.7}, {0.025, 0.1, 0.72}};
    const auto map = calib::bandMap(display, display.width, display.height, eyes);
    expectShown(display, map, gpu::TileFilter::Nearest);
    const auto* screen = std::get_if<calib::LineScreen>(&display.law);
    const auto* lens = std::get_if<calib::TrackedLens>(&display.law);
    const Real start = screen != nullptr ? screen->dutyCycle + screen->guard / 2 : 0;
    const Real end = screen != nullptr ? 1 - screen->guard / 2 : lens->fill;
    std::size_t wrong = 0;
    for (std::size_t eye = 0; eye < eyes.size(); ++eye)
        for (int y = 0; y < display.height; ++y)
            for (int x = 0; x < display.width; ++x)
                for (int c = 0; c < 3; ++c) {
                    const Real phase = oracle::fraction(
                        screen != nullptr ? oracle::lineScreen(*screen, display, eyes[eye], x, y, c)
                                          : oracle::trackedLens(*lens, eyes[eye], x, y, c));
                    const Real edge = std::min({std::abs(phase - start), std::abs(phase - end),
                                                std::abs(phase + 1 - end), phase, 1 - phase});
                    // Bands beyond the slit (guard < 0) end in the next cycle.
                    const bool lit = (phase >= start && phase < end) || phase + 1 < end;
                    if (map.lit(eye, x, y, c) != lit && edge > kTieBound) ++wrong;
                }
    EXPECT_EQ(wrong, 0U);
}

std::string displaysName(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::ranges::replace_if(
        name, [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
    return name;
}

template<class Fits>
std::vector<std::string> displaysThat(Fits fits) {
    std::vector<std::string> names;
    for (const std::string& name : config::displayNames())
        if (fits(config::loadDisplay(name))) names.push_back(name);
    return names;
}

bool hasPhaseLaw(const calib::DisplayProfile& display) {
    return static_cast<bool>(oracle::phaseFunction(display));
}
bool hasLensLaw(const calib::DisplayProfile& display) {
    return calib::affinePhase(display.law, display.views).has_value();
}
bool hasBandLaw(const calib::DisplayProfile& display) {
    return std::holds_alternative<calib::LineScreen>(display.law) ||
           std::holds_alternative<calib::TrackedLens>(display.law);
}

INSTANTIATE_TEST_SUITE_P(Shipped, DisplaysWithPhase, testing::ValuesIn(displaysThat(hasPhaseLaw)),
                         displaysName);
INSTANTIATE_TEST_SUITE_P(Shipped, DisplaysWithLens, testing::ValuesIn(displaysThat(hasLensLaw)),
                         displaysName);
INSTANTIATE_TEST_SUITE_P(Shipped, DisplaysWithBands, testing::ValuesIn(displaysThat(hasBandLaw)),
                         displaysName);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(DisplaysWithBands);

/// No such panel is sold; phases must not wear out before one is.
TEST(FuturePanel, SixteenThousandPixelsAndAHundredViews) {
    calib::LookingGlassCalibration unit;
    unit.pitch = 76.1092;
    unit.slope = -7.7;
    unit.center = 0.3;
    unit.dpi = 560;
    unit.screenWidth = 15360;
    unit.screenHeight = 8640;
    calib::DisplayProfile display;
    display.name = "16k";
    display.width = unit.screenWidth;
    display.height = unit.screenHeight;
    display.views = kManyViews;
    display.law = unit;
    expectAgreement(display, calib::makeViewMap(display, display.width, display.height));
}

} // namespace
} // namespace autostereo::test

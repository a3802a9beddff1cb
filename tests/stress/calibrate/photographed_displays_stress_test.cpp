// Whole displays, measured from twelve simulated photographs each.

#include "tests/stress/campaign.hpp"
#include "tests/unit/calibrate/simulated_panels.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace autostereo::calibrate {
namespace {

struct Shipped {
    const char* name;
    int views; ///< 0: as the file says
    /// Views that its phase may be off by where the sheet is bent. A slit shows one sub-pixel at a
    /// time: steps of one view with five views a lens, off by 0.3 rms, which three places and
    /// the neighbours in a block average to about a third; lenses mix sub-pixels.
    double bentLimit = 0.1;
};

class PhotographedDisplays : public testing::TestWithParam<Shipped> {};

TEST_P(PhotographedDisplays, PhaseIsRightToATenthOfAView) {
    auto model = config::loadDisplay(GetParam().name);
    if (GetParam().views > 0) model.views = GetParam().views;
    const auto unit = unitOf(model, 7, 1);
    test::PanelCamera camera(2000, 1500, 3);
    const auto found =
        calibrateDisplay(model, sightsOf(unit, model, placesFor(model, camera), camera));
    const double error = phaseErrorViews(found.display, unit, 0.99);
    std::printf("%s, %d views: %.4f views off at p99 (stated %.4f)\n", GetParam().name, model.views,
                error, found.half95Views);
    EXPECT_LT(error, 0.1);
    EXPECT_GT(phaseErrorViews(model, unit, 0.99), 0.3); // the model alone does not fit
}

TEST_P(PhotographedDisplays, ABentSheetIsRightToATenthOfAView) {
    auto model = config::loadDisplay(GetParam().name);
    if (GetParam().views > 0) model.views = GetParam().views;
    const auto unit = bent(unitOf(model, 7, 1), 1.0 / model.views);
    test::PanelCamera camera(2000, 1500, 3);
    const auto found =
        calibrateDisplay(model, sightsOf(unit, model, placesFor(model, camera), camera));
    const double error = phaseErrorViews(found.display, unit, 0.99);
    auto flat = found.display;
    calib::phaseGrid(flat.law)->cycles.clear();
    std::printf("%s, %d views: %.4f views off at p99 (stated %.4f), without the grid %.4f\n",
                GetParam().name, model.views, error, found.half95Views,
                phaseErrorViews(flat, unit, 0.99));
    EXPECT_LT(error, GetParam().bentLimit);
    EXPECT_GT(phaseErrorViews(flat, unit, 0.99), 0.3);
}

/// The largest one takes minutes and a gigabyte: with the campaigns at full length only.
std::vector<Shipped> shipped() {
    std::vector<Shipped> displays{{"looking-glass-portrait", 0},
                                  {"slanted-8view-1080p", 0},
                                  {"barrier-5view", 0, 0.2},
                                  {"personal-varrier-30", 0},
                                  {"looking-glass-8k-gen1", 100}};
    displays.resize(test::campaign(displays.size() - 1, displays.size()));
    return displays;
}

INSTANTIATE_TEST_SUITE_P(Shipped, PhotographedDisplays, testing::ValuesIn(shipped()),
                         [](const auto& each) {
                             std::string name = each.param.name;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

} // namespace
} // namespace autostereo::calibrate

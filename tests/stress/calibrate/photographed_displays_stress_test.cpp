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

/// The largest one takes minutes and a gigabyte: with the campaigns at full length only.
std::vector<Shipped> shipped() {
    std::vector<Shipped> displays{{"looking-glass-portrait", 0},
                                  {"slanted-8view-1080p", 0},
                                  {"barrier-5view", 0},
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

#include "gpu/atlas.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace autostereo::gpu {
namespace {

TEST(AtlasLayout, ViewZeroIsBottomLeftAndTheLastTopRight) {
    calib::DisplayProfile display;
    display.views = 48;
    display.quilt = {8, 6, 420, 560};
    const AtlasLayout layout = atlasLayout(display, 1536, 2048);
    EXPECT_EQ(layout.width(), 3360);
    EXPECT_EQ(layout.height(), 3360);
    EXPECT_EQ(std::pair(layout.left(0), layout.bottom(0)), std::pair(0, 0));
    EXPECT_EQ(std::pair(layout.left(1), layout.bottom(1)), std::pair(420, 0));
    EXPECT_EQ(std::pair(layout.left(7), layout.bottom(7)), std::pair(2940, 0));
    EXPECT_EQ(std::pair(layout.left(8), layout.bottom(8)), std::pair(0, 560));
    EXPECT_EQ(std::pair(layout.left(47), layout.bottom(47)), std::pair(2940, 2800));
}

TEST(AtlasLayout, EveryViewHasItsOwnTileInside) {
    const AtlasLayout layout{5, {3, 2, 640, 480}};
    std::set<std::pair<int, int>> corners;
    for (int view = 0; view < layout.views; ++view) {
        const int left = layout.left(view), bottom = layout.bottom(view);
        EXPECT_EQ(left % 640, 0);
        EXPECT_EQ(bottom % 480, 0);
        EXPECT_LE(left + 640, layout.width());
        EXPECT_LE(bottom + 480, layout.height());
        corners.emplace(left, bottom);
    }
    EXPECT_EQ(corners.size(), 5U);
}

TEST(AtlasLayout, ProfileWithoutTilesTakesThePanelsSize) {
    calib::DisplayProfile display;
    display.views = 2;
    display.quilt = {2, 1, 0, 0};
    const AtlasLayout layout = atlasLayout(display, 1280, 800);
    EXPECT_EQ(layout.views, 2);
    EXPECT_EQ(layout.width(), 2560);
    EXPECT_EQ(layout.height(), 800);
    EXPECT_EQ(layout.left(1), 1280);
    EXPECT_EQ(layout.bottom(1), 0);
}

} // namespace
} // namespace autostereo::gpu

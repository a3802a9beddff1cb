#include "devices/pixel_sharing.hpp"

#include <gtest/gtest.h>

namespace autostereo::test {
namespace {

using devices::PixelSharing;
using devices::PixelWay;

class NoMemory final : public devices::PixelMemory {
  public:
    devices::UniqueFd allocate(std::size_t, std::size_t) override { return {}; }
};

TEST(PixelSharing, EveryWayIsTriedInItsOrderAndNoneTwice) {
    PixelSharing sharing;
    EXPECT_EQ(sharing.way(), PixelWay::Copied);
    EXPECT_FALSE(sharing.answered());
    const auto memory = std::make_shared<NoMemory>();
    sharing.offer(memory);
    EXPECT_TRUE(sharing.answered());
    EXPECT_EQ(sharing.memory(), memory);
    EXPECT_EQ(sharing.way(), PixelWay::Filled);
    sharing.refuse(PixelWay::Filled, "not today");
    EXPECT_EQ(sharing.way(), PixelWay::Exported);
    sharing.refuse(PixelWay::Filled, "said by the other side too");
    EXPECT_EQ(sharing.way(), PixelWay::Exported);
    sharing.offer(memory);
    EXPECT_EQ(sharing.way(), PixelWay::Exported) << "refusals are for good";
    sharing.refuse(PixelWay::Exported, "nor that");
    EXPECT_EQ(sharing.way(), PixelWay::Copied);
    sharing.refuse(PixelWay::Copied, "there is nothing else");
    EXPECT_EQ(sharing.way(), PixelWay::Copied);
}

TEST(PixelSharing, WithoutMemoryOnlyTheDriversOwnIsShared) {
    PixelSharing sharing;
    sharing.offer(nullptr);
    EXPECT_EQ(sharing.way(), PixelWay::Exported);
}

TEST(PixelSharing, WhatIsDeclinedStaysCopied) {
    PixelSharing sharing;
    sharing.decline("the context is not EGL's");
    sharing.offer(std::make_shared<NoMemory>());
    EXPECT_TRUE(sharing.answered());
    EXPECT_EQ(sharing.way(), PixelWay::Copied);
}

} // namespace
} // namespace autostereo::test

#include "devices/display/recognise.hpp"

#include <gtest/gtest.h>

namespace autostereo::test {
namespace {

using namespace devices;

Connector monitor(const std::string& name, const std::string& edidName, int width, int height) {
    Connector one;
    one.card = "card0";
    one.name = name;
    one.edid.emplace();
    one.edid->monitorName = edidName;
    one.edid->nativeWidth = width;
    one.edid->nativeHeight = height;
    return one;
}

const std::vector<RecognitionRule> kRules{{"portrait", "LKG*", 1536, 2048},
                                          {"8k", "LKG*", 7680, 4320},
                                          {"cubevi", "CubeVi", 1440, 2560},
                                          {"preview", "", 0, 0}};

Recognised one(const Recognition& result) {
    if (const auto* found = std::get_if<Recognised>(&result)) return *found;
    if (const auto* none = std::get_if<NotRecognised>(&result)) ADD_FAILURE() << none->reason;
    if (const auto* many = std::get_if<Ambiguous>(&result)) ADD_FAILURE() << many->reason;
    return {};
}

TEST(Recognise, NamePatterns) {
    EXPECT_TRUE(edidNameFits("LKG*", "LKG01Do12HjQE"));
    EXPECT_TRUE(edidNameFits("LKG*", "LKG"));
    EXPECT_FALSE(edidNameFits("LKG*", "xLKG"));
    EXPECT_TRUE(edidNameFits("CubeVi", "CubeVi"));
    EXPECT_FALSE(edidNameFits("CubeVi", "CubeVi2"));
    EXPECT_FALSE(edidNameFits("*", "anything"));
    EXPECT_FALSE(edidNameFits("", ""));
}

TEST(Recognise, ByNameAndSize) {
    const std::vector monitors{monitor("eDP-1", "", 1920, 1080),
                               monitor("HDMI-A-1", "LKG01Do12HjQE", 1536, 2048)};
    EXPECT_EQ(one(recognise(monitors, kRules)), (Recognised{"portrait", "card0", "HDMI-A-1"}));
    Connector big = monitor("DP-1", "LKG", 3840, 2160);
    big.modes = {{7680, 4320}};
    EXPECT_EQ(one(recognise(std::vector{big}, kRules)).profile, "8k");
}

TEST(Recognise, NeitherNameNorSizeIsEnough) {
    const auto reason = [](const std::vector<Connector>& monitors) {
        const auto result = recognise(monitors, kRules);
        const auto* none = std::get_if<NotRecognised>(&result);
        return none == nullptr ? "recognised" : none->reason;
    };
    EXPECT_NE(reason({monitor("DP-1", "LKG01", 1920, 1080)}).find("DP-1 'LKG01'"),
              std::string::npos);
    EXPECT_NE(reason({monitor("DP-1", "DELL", 1536, 2048)}).find("DELL"), std::string::npos);
    Connector bare = monitor("DP-1", "", 1536, 2048);
    bare.edid.reset();
    bare.modes = {{1536, 2048}};
    EXPECT_NE(reason({bare}).find("without an EDID"), std::string::npos);
    EXPECT_EQ(reason({}), "no monitor is connected");
}

TEST(Recognise, TwoMonitorsAreAmbiguous) {
    const std::vector monitors{monitor("HDMI-A-1", "LKG1", 1536, 2048),
                               monitor("HDMI-A-2", "LKG2", 1536, 2048)};
    const auto result = recognise(monitors, kRules);
    const auto* many = std::get_if<Ambiguous>(&result);
    ASSERT_NE(many, nullptr);
    ASSERT_EQ(many->candidates.size(), 2U);
    EXPECT_EQ(many->candidates[1].connector, "HDMI-A-2");
    EXPECT_NE(many->reason.find("portrait on card0 HDMI-A-1"), std::string::npos) << many->reason;
}

TEST(Recognise, TheMostExactRuleCounts) {
    std::vector<RecognitionRule> rules{{"family", "LKG*", 1536, 2048},
                                       {"model", "LKG01*", 1536, 2048},
                                       {"unit", "LKG01Do", 1536, 2048},
                                       {"model again", "LKG01Do*", 1536, 2048}};
    const std::vector monitors{monitor("DP-1", "LKG01Do", 1536, 2048)};
    EXPECT_EQ(one(recognise(monitors, rules)).profile, "unit");
    EXPECT_EQ(one(recognise(std::vector{monitor("DP-1", "LKG01x", 1536, 2048)}, rules)).profile,
              "model");
    rules.push_back({"twin", "LKG01Do", 0, 0});
    EXPECT_TRUE(std::holds_alternative<Ambiguous>(recognise(monitors, rules)));
    rules.back().profile = "unit"; // the same answer twice is one
    EXPECT_EQ(one(recognise(monitors, rules)).profile, "unit");
}

} // namespace
} // namespace autostereo::test

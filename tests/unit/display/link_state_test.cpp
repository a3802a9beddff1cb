#include "devices/display/link_state.hpp"

#include "tests/support/edid_bytes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace autostereo::test {
namespace {

using namespace devices;
using Severity = LinkProblem::Severity;

/// Everything known, and good.
LinkState goodLink() {
    LinkState link;
    link.rotationDeg = 0;
    link.reflected = false;
    link.source = link.shown = link.mode = link.native = PixelSize{1920, 1080};
    link.interlaced = false;
    link.modeScaling = ModeScaling::FullAspect;
    link.border = PixelSize{};
    link.colorFormat = ColorFormat::Rgb;
    link.colorSpace = "Default";
    link.range = ColorRange::Full;
    link.gammaIsIdentity = link.degammaIsIdentity = true;
    link.colorMatrix = ColorMatrix::Identity;
    link.hdr = false;
    link.maxBitsPerChannel = 8;
    link.dithering = false;
    link.linkGood = true;
    link.monitorOverscans = false;
    link.rangeSelectable = true;
    return link;
}

TEST(LinkState, NothingIsWrongWithAGoodOrAnUnknownLink) {
    EXPECT_TRUE(linkProblems(goodLink()).empty());
    EXPECT_TRUE(linkProblems({}).empty());
}

struct Case {
    const char* name;
    Severity severity;
    const char* words;
    std::function<void(LinkState&)> spoil;
};

class OneFault : public testing::TestWithParam<Case> {};

TEST_P(OneFault, IsTheOnlyProblemAndSaysWhatToDo) {
    LinkState link = goodLink();
    GetParam().spoil(link);
    const auto problems = linkProblems(link);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].severity, GetParam().severity);
    EXPECT_NE(problems[0].text.find(GetParam().words), std::string::npos) << problems[0].text;
    EXPECT_NE(problems[0].text.find(": "), std::string::npos) << "what to do: " << problems[0].text;
    EXPECT_EQ(problems[0].text.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    All, OneFault,
    testing::Values(
        Case{"Rotated", Severity::Refuse, "90 degrees", [](auto& l) { l.rotationDeg = 90; }},
        Case{"Mirrored", Severity::Refuse, "mirrored", [](auto& l) { l.reflected = true; }},
        Case{"Interlaced", Severity::Refuse, "interlaced", [](auto& l) { l.interlaced = true; }},
        Case{"PlaneScaled", Severity::Refuse, "960x540 to 1920x1080",
             [](auto& l) {
                 l.source = PixelSize{960, 540};
             }},
        Case{"OtherMode", Severity::Refuse, "native one is 3840x2160",
             [](auto& l) {
                 l.native = PixelSize{3840, 2160};
             }},
        Case{"NotFilling", Severity::Refuse, "does not fill",
             [](auto& l) {
                 l.source = l.shown = PixelSize{1900, 1080};
             }},
        Case{"ScaledToUnknown", Severity::Warn, "scaling mode", [](auto& l) { l.native.reset(); }},
        Case{"Underscan", Severity::Refuse, "border of 16x0",
             [](auto& l) {
                 l.border = PixelSize{16, 0};
             }},
        Case{"Overscan", Severity::Warn, "overscan", [](auto& l) { l.monitorOverscans = true; }},
        Case{"Ycbcr422", Severity::Refuse, "4:2:2",
             [](auto& l) { l.colorFormat = ColorFormat::Ycbcr422; }},
        Case{"Ycbcr420", Severity::Refuse, "4:2:0",
             [](auto& l) { l.colorFormat = ColorFormat::Ycbcr420; }},
        Case{"Ycbcr444", Severity::Warn, "4:4:4",
             [](auto& l) { l.colorFormat = ColorFormat::Ycbcr444; }},
        Case{"Colorspace", Severity::Warn, "BT2020_YCC",
             [](auto& l) { l.colorSpace = "BT2020_YCC"; }},
        Case{"Limited", Severity::Warn, "limited range",
             [](auto& l) { l.range = ColorRange::Limited; }},
        Case{"Automatic", Severity::Warn, "does not say that it follows",
             [](auto& l) {
                 l.range = ColorRange::Automatic;
                 l.rangeSelectable = false;
             }},
        Case{"Mixing", Severity::Refuse, "mixes red",
             [](auto& l) { l.colorMatrix = ColorMatrix::Mixing; }},
        Case{"ChannelGain", Severity::Warn, "scales the channels",
             [](auto& l) { l.colorMatrix = ColorMatrix::Scaling; }},
        Case{"Gamma", Severity::Warn, "gamma ramp", [](auto& l) { l.gammaIsIdentity = false; }},
        Case{"Degamma", Severity::Warn, "degamma", [](auto& l) { l.degammaIsIdentity = false; }},
        Case{"Hdr", Severity::Warn, "HDR", [](auto& l) { l.hdr = true; }},
        Case{"SixBits", Severity::Warn, "6 bits", [](auto& l) { l.maxBitsPerChannel = 6; }},
        Case{"Dithering", Severity::Warn, "dithers", [](auto& l) { l.dithering = true; }},
        Case{"BadLink", Severity::Warn, "training", [](auto& l) { l.linkGood = false; }}),
    [](const auto& one) { return one.param.name; });

TEST(LinkState, TheWorstComesFirst) {
    LinkState link = goodLink();
    link.gammaIsIdentity = false;
    link.rotationDeg = 180;
    link.colorMatrix = ColorMatrix::Mixing;
    const auto problems = linkProblems(link);
    ASSERT_EQ(problems.size(), 3U);
    EXPECT_EQ(problems[0].severity, Severity::Refuse);
    EXPECT_EQ(problems[1].severity, Severity::Refuse);
    EXPECT_EQ(problems[2].severity, Severity::Warn);
}

TEST(LinkState, AutomaticRangeIsFineWhereTheMonitorFollows) {
    LinkState link = goodLink();
    link.range = ColorRange::Automatic;
    EXPECT_TRUE(linkProblems(link).empty());
}

TEST(LinkState, APreferredTimingSaysNothingAboutAPanelWiderThanItCan) {
    LinkState link = goodLink();
    link.source = link.shown = link.mode = PixelSize{7680, 4320};
    link.native = PixelSize{3840, 2160};
    EXPECT_TRUE(linkProblems(link).empty());
}

TEST(LinkState, TakesOverWhatTheMonitorSays) {
    LinkState dell;
    addMonitor(std::get<Edid>(parseEdid(bytesOfHex(kDell))), dell);
    EXPECT_EQ(dell.native, (PixelSize{1920, 1080}));
    EXPECT_EQ(dell.monitorOverscans, false);
    EXPECT_EQ(dell.rangeSelectable, false);
    LinkState lg;
    addMonitor(std::get<Edid>(parseEdid(bytesOfHex(kLg))), lg);
    EXPECT_EQ(lg.monitorOverscans, true) << "it does not promise to underscan";
    EXPECT_EQ(lg.rangeSelectable, true);
    LinkState panel;
    addMonitor(std::get<Edid>(parseEdid(bytesOfHex(kBoe))), panel);
    EXPECT_EQ(panel.monitorOverscans, false);
    EXPECT_EQ(panel.rangeSelectable, true);
}

std::vector<std::uint16_t> ramp(std::size_t size, double gamma, double gain = 1) {
    std::vector<std::uint16_t> values(size);
    for (std::size_t i = 0; i < size; ++i)
        values[i] = static_cast<std::uint16_t>(
            std::lround(65535 * gain *
                        std::pow(static_cast<double>(i) / static_cast<double>(size - 1), gamma)));
    return values;
}

TEST(IdentityRamp, IsToldFromNightLightAndProfiles) {
    for (const std::size_t size : {2U, 256U, 1024U, 4096U}) {
        EXPECT_TRUE(isIdentityRamp(ramp(size, 1))) << size;
        EXPECT_FALSE(isIdentityRamp(ramp(size, 1, 0.9))) << size;
    }
    EXPECT_FALSE(isIdentityRamp(ramp(256, 1.05)));
    EXPECT_FALSE(isIdentityRamp(ramp(1024, 1 / 1.05)));
    std::vector<std::uint16_t> bytes(256);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint16_t>(i << 8U);
    EXPECT_TRUE(isIdentityRamp(bytes)) << "as a driver of 8 bits writes it";
    EXPECT_TRUE(isIdentityRamp({}));
    EXPECT_FALSE(isIdentityRamp(std::vector<std::uint16_t>(1)));
    std::vector<std::uint16_t> inverse = ramp(256, 1);
    std::ranges::reverse(inverse);
    EXPECT_FALSE(isIdentityRamp(inverse));
}

} // namespace
} // namespace autostereo::test

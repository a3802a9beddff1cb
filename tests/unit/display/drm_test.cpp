#include "devices/display/drm_properties.hpp"
#include "devices/display/drm_reader.hpp"

#include "devices/display/connectors.hpp"
#include "tests/support/data.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace autostereo::test {
namespace {

using namespace devices;
using Blob = std::vector<std::byte>;

template<class Number>
void append(Blob& blob, Number number) {
    const auto at = blob.size();
    blob.resize(at + sizeof number);
    std::memcpy(blob.data() + at, &number, sizeof number);
}

Blob table(std::size_t size, double blueGain) {
    Blob blob;
    for (std::size_t i = 0; i < size; ++i) {
        const double level = 65535.0 * static_cast<double>(i) / static_cast<double>(size - 1);
        for (const double gain : {1.0, 1.0, blueGain, 0.0})
            append(blob, static_cast<std::uint16_t>(level * gain));
    }
    return blob;
}

Blob matrix(std::array<double, 9> entries) {
    Blob blob;
    for (const double entry : entries)
        append(blob, static_cast<std::uint64_t>(std::ldexp(std::abs(entry), 32)) |
                         (entry < 0 ? 1ULL << 63U : 0));
    return blob;
}

Blob mode(std::uint16_t width, std::uint16_t height, std::uint32_t flags) {
    Blob blob;
    append(blob, std::uint32_t{148500}); // kHz
    for (const std::uint16_t size : {width, width, width, width, std::uint16_t{0}, height, height,
                                     height, height, std::uint16_t{0}})
        append(blob, size);
    append(blob, std::uint32_t{60});
    append(blob, flags);
    blob.resize(68);
    return blob;
}

DrmProperty number(const char* name, std::uint64_t value) { return {name, value, "", {}}; }
DrmProperty word(const char* name, const char* value) { return {name, 1, value, {}}; }
DrmProperty blob(const char* name, Blob bytes) { return {name, 1, "", std::move(bytes)}; }

LinkState connector(std::vector<DrmProperty> properties) {
    return linkStateOf({"card0", "HDMI-A-1", std::move(properties), {}, {}});
}
LinkState crtc(std::vector<DrmProperty> properties) {
    return linkStateOf({"card0", "HDMI-A-1", {}, std::move(properties), {}});
}
LinkState plane(std::vector<DrmProperty> properties) {
    return linkStateOf({"card0", "HDMI-A-1", {}, {}, std::move(properties)});
}

TEST(DrmProperties, NothingKnownFromNothing) {
    const LinkState link = linkStateOf({});
    EXPECT_FALSE(link.rotationDeg || link.border || link.colorFormat || link.range || link.mode ||
                 link.gammaIsIdentity || link.colorMatrix || link.hdr || link.maxBitsPerChannel);
}

TEST(DrmProperties, RangeAndFormat) {
    EXPECT_EQ(connector({word("Broadcast RGB", "Automatic")}).range, ColorRange::Automatic);
    EXPECT_EQ(connector({word("Broadcast RGB", "Full")}).range, ColorRange::Full);
    EXPECT_EQ(connector({word("Broadcast RGB", "Limited 16:235")}).range, ColorRange::Limited);
    EXPECT_FALSE(connector({word("Broadcast RGB", "Sideways")}).range);
    EXPECT_EQ(connector({word("color format", "YCBCR 4:2:0")}).colorFormat, ColorFormat::Ycbcr420);
    EXPECT_EQ(connector({word("active color format", "ycbcr422")}).colorFormat,
              ColorFormat::Ycbcr422);
    EXPECT_EQ(connector({word("color format", "rgb")}).colorFormat, ColorFormat::Rgb);
    EXPECT_FALSE(connector({word("color format", "auto")}).colorFormat);
    EXPECT_EQ(connector({word("Colorspace", "BT2020_RGB")}).colorSpace, "BT2020_RGB");
}

TEST(DrmProperties, Depth) {
    EXPECT_EQ(connector({number("max bpc", 6)}).maxBitsPerChannel, 6);
    EXPECT_FALSE(connector({number("max bpc", 1ULL << 40U)}).maxBitsPerChannel);
    EXPECT_EQ(connector({word("dither", "on")}).dithering, true);
    EXPECT_EQ(connector({word("dithering mode", "off")}).dithering, false);
    EXPECT_FALSE(connector({word("dithering mode", "auto")}).dithering);
    EXPECT_EQ(connector({word("link-status", "Bad")}).linkGood, false);
    EXPECT_EQ(connector({blob("HDR_OUTPUT_METADATA", {})}).hdr, false);
    EXPECT_EQ(connector({blob("HDR_OUTPUT_METADATA", Blob(32))}).hdr, true);
    EXPECT_EQ(connector({word("scaling mode", "Full aspect")}).modeScaling,
              ModeScaling::FullAspect);
}

TEST(DrmProperties, Borders) {
    EXPECT_EQ(connector({word("underscan", "off"), number("underscan hborder", 32)}).border,
              (PixelSize{0, 0}));
    EXPECT_EQ(connector({word("underscan", "on"), number("underscan hborder", 32),
                         number("underscan vborder", 18)})
                  .border,
              (PixelSize{32, 18}));
    EXPECT_EQ(connector({word("underscan", "auto")}).border, (PixelSize{0, 0}));
    EXPECT_EQ(connector({number("left margin", 0), number("right margin", 7),
                         number("top margin", 3), number("bottom margin", ~0ULL)})
                  .border,
              (PixelSize{7, 4096}));
}

TEST(DrmProperties, Tables) {
    EXPECT_EQ(crtc({blob("GAMMA_LUT", {})}).gammaIsIdentity, true);
    EXPECT_EQ(crtc({blob("GAMMA_LUT", table(1024, 1))}).gammaIsIdentity, true);
    EXPECT_EQ(crtc({blob("GAMMA_LUT", table(1024, 0.7))}).gammaIsIdentity, false);
    EXPECT_EQ(crtc({blob("DEGAMMA_LUT", table(33, 0.7))}).degammaIsIdentity, false);
    EXPECT_FALSE(crtc({blob("GAMMA_LUT", Blob(2049))}).gammaIsIdentity) << "no whole entries";
}

TEST(DrmProperties, Matrices) {
    EXPECT_EQ(crtc({blob("CTM", {})}).colorMatrix, ColorMatrix::Identity);
    EXPECT_EQ(crtc({blob("CTM", matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}))}).colorMatrix,
              ColorMatrix::Identity);
    EXPECT_EQ(crtc({blob("CTM", matrix({1, 0, 0, 0, 0.9, 0, 0, 0, 0.7}))}).colorMatrix,
              ColorMatrix::Scaling);
    EXPECT_EQ(crtc({blob("CTM", matrix({1.1, -0.1, 0, 0, 1, 0, 0, 0, 1}))}).colorMatrix,
              ColorMatrix::Mixing);
    EXPECT_EQ(crtc({blob("CTM", matrix({-1, 0, 0, 0, 1, 0, 0, 0, 1}))}).colorMatrix,
              ColorMatrix::Scaling)
        << "the sign is a bit of its own";
    EXPECT_FALSE(crtc({blob("CTM", Blob(71))}).colorMatrix);
}

TEST(DrmProperties, Modes) {
    const LinkState link = crtc({blob("MODE_ID", mode(1536, 2048, 5))});
    EXPECT_EQ(link.mode, (PixelSize{1536, 2048}));
    EXPECT_EQ(link.interlaced, false);
    EXPECT_EQ(crtc({blob("MODE_ID", mode(1920, 1080, 0x15))}).interlaced, true);
    EXPECT_FALSE(crtc({blob("MODE_ID", Blob(67))}).mode);
    EXPECT_FALSE(crtc({blob("MODE_ID", {})}).mode);
}

TEST(DrmProperties, Planes) {
    EXPECT_EQ(plane({number("rotation", 1)}).rotationDeg, 0);
    EXPECT_EQ(plane({number("rotation", 1)}).reflected, false);
    EXPECT_EQ(plane({number("rotation", 8)}).rotationDeg, 270);
    EXPECT_EQ(plane({number("rotation", 0x11)}).reflected, true);
    const std::vector<DrmProperty> sizes{number("SRC_W", 1080ULL << 16U),
                                         number("SRC_H", 1920ULL << 16U), number("CRTC_W", 1920),
                                         number("CRTC_H", 1080)};
    EXPECT_EQ(plane(sizes).source, (PixelSize{1080, 1920}));
    EXPECT_EQ(plane(sizes).shown, (PixelSize{1920, 1080}));
    auto turned = sizes;
    turned.push_back(number("rotation", 2));
    EXPECT_EQ(plane(turned).source, plane(turned).shown) << "turned, but not scaled";
    EXPECT_FALSE(plane({number("SRC_W", 0), number("SRC_H", 0)}).source) << "a dark plane";
}

TEST(DrmReader, WhatIsNoCardIsNotedAndLeftOut) {
    const ScratchFolder folder;
    EXPECT_TRUE(readDrm(folder / "missing").notes.empty());
    folder.write("card0", "nothing");
    folder.write("renderD128", "nothing");
    std::filesystem::create_directories(folder / "card1");
    const DrmReading reading = readDrm(folder.path());
    EXPECT_TRUE(reading.pipes.empty());
    ASSERT_EQ(reading.notes.size(), 2U);
    EXPECT_NE(reading.notes[0].find("card0: drives no monitors"), std::string::npos);
    EXPECT_NE(reading.notes[1].find("card1: cannot open"), std::string::npos);
}

/// Wherever there is a card with a monitor, kernel and files must tell the same story.
TEST(DrmReader, RealCardsAgreeWithSysfs) {
    const DrmReading reading = readDrm("/dev/dri");
    if (reading.pipes.empty()) {
        const std::string why =
            reading.notes.empty() ? "no card in /dev/dri" : reading.notes.front();
        if (required("drm")) FAIL() << why;
        GTEST_SKIP() << why;
    }
    const auto monitors = connectedMonitors("/");
    for (const DrmPipe& pipe : reading.pipes) {
        const auto same = [&](const Connector& one) {
            return one.card == pipe.card && one.name == pipe.connector;
        };
        EXPECT_EQ(std::ranges::count_if(monitors, same), 1) << pipe.card << " " << pipe.connector;
        EXPECT_FALSE(pipe.connectorProperties.empty());
    }
}

} // namespace
} // namespace autostereo::test

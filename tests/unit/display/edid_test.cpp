#include "devices/display/edid.hpp"

#include "tests/support/edid_bytes.hpp"

#include <gtest/gtest.h>

#include <random>

namespace autostereo::test {
namespace {

using devices::Edid;
using devices::EdidError;
using devices::parseEdid;

Edid good(const Bytes& bytes) {
    auto parsed = parseEdid(bytes);
    if (const auto* error = std::get_if<EdidError>(&parsed)) {
        ADD_FAILURE() << error->text;
        return {};
    }
    return std::get<Edid>(parsed);
}

std::string errorOf(const Bytes& bytes) {
    const auto parsed = parseEdid(bytes);
    const auto* error = std::get_if<EdidError>(&parsed);
    return error == nullptr ? "no error" : error->text;
}

TEST(EdidTest, DellOnHdmi) {
    const Edid edid = good(bytesOfHex(kDell));
    EXPECT_EQ(edid.manufacturer, "DEL");
    EXPECT_EQ(edid.product, 0x2013);
    EXPECT_EQ(edid.serialNumber, 0x39363945U);
    EXPECT_EQ(edid.monitorName, "DELL D2721H");
    EXPECT_EQ(edid.serialText, "3S5GQ23");
    EXPECT_EQ(edid.nativeWidth, 1920);
    EXPECT_EQ(edid.nativeHeight, 1080);
    EXPECT_NEAR(edid.refreshHz, 60, 1e-9);
    EXPECT_FALSE(edid.interlaced);
    EXPECT_DOUBLE_EQ(edid.widthM, 0.598);
    EXPECT_DOUBLE_EQ(edid.heightM, 0.336);
    EXPECT_TRUE(edid.digital);
    EXPECT_EQ(edid.bitsPerChannel, 0);
    EXPECT_TRUE(edid.cea && edid.hdmi && edid.underscans && edid.ycbcr444 && edid.ycbcr422);
    EXPECT_FALSE(edid.ycbcr420 || edid.quantisationSelectable || edid.alwaysOverscans);
    EXPECT_TRUE(edid.faults.empty());
    EXPECT_FALSE(devices::isLookingGlass(edid));
}

TEST(EdidTest, LgThatLetsTheSourceChooseTheRange) {
    const Edid edid = good(bytesOfHex(kLg));
    EXPECT_EQ(edid.manufacturer, "GSM");
    EXPECT_EQ(edid.monitorName, "LG SDQHD");
    EXPECT_EQ(edid.serialText, "207NTRLDC430");
    EXPECT_EQ(edid.nativeWidth, 2560);
    EXPECT_EQ(edid.nativeHeight, 2880);
    EXPECT_NEAR(edid.refreshHz, 59.966, 0.001);
    EXPECT_TRUE(edid.hdmi && edid.quantisationSelectable && edid.ycbcr420);
    EXPECT_TRUE(edid.ycbcr444 && edid.ycbcr422);
    EXPECT_FALSE(edid.underscans || edid.alwaysOverscans);
    EXPECT_DOUBLE_EQ(edid.widthM, 0.465);
    EXPECT_DOUBLE_EQ(edid.heightM, 0.523);
    EXPECT_TRUE(edid.faults.empty()) << edid.faults.front();
}

TEST(EdidTest, VideoCapabilitiesBitByBit) {
    Bytes bytes = bytesOfHex(kLg);
    std::size_t at = 128 + 4;
    while (bytes.at(at) != std::byte{0xe2} || bytes.at(at + 1) != std::byte{0})
        ++at;
    const auto with = [&](unsigned capabilities) {
        bytes[at + 2] = static_cast<std::byte>(capabilities);
        seal(bytes, 1);
        return good(bytes);
    };
    EXPECT_TRUE(with(0x40).quantisationSelectable);
    EXPECT_FALSE(with(0xbf).quantisationSelectable);
    EXPECT_TRUE(with(0x04).alwaysOverscans);
    for (const unsigned other : {0x00U, 0x08U, 0x0cU, 0xf3U})
        EXPECT_FALSE(with(other).alwaysOverscans) << other;
}

TEST(EdidTest, NotebookPanelWithoutNameOrExtension) {
    const Edid edid = good(bytesOfHex(kBoe));
    EXPECT_EQ(edid.manufacturer, "BOE");
    EXPECT_EQ(edid.monitorName, "");
    EXPECT_EQ(edid.nativeWidth, 2256);
    EXPECT_EQ(edid.nativeHeight, 1504);
    EXPECT_EQ(edid.bitsPerChannel, 8);
    EXPECT_FALSE(edid.cea || edid.hdmi || edid.ycbcr422 || edid.underscans);
}

TEST(EdidTest, LookingGlassByItsName) {
    const Edid edid = good(syntheticEdid("LKG01Do12HjQ", 1536, 2048));
    EXPECT_TRUE(devices::isLookingGlass(edid));
    EXPECT_EQ(edid.monitorName, "LKG01Do12HjQ");
    EXPECT_EQ(edid.nativeWidth, 1536);
    EXPECT_EQ(edid.nativeHeight, 2048);
    EXPECT_DOUBLE_EQ(edid.widthM, 0.12);
    EXPECT_FALSE(devices::isLookingGlass(good(syntheticEdid("xLKG", 1536, 2048))));
}

TEST(EdidTest, TextIsMadePrintable) {
    Bytes bytes = syntheticEdid("a", 800, 600);
    for (std::size_t i = 0; i < 13; ++i)
        bytes[72 + 5 + i] = static_cast<std::byte>(i < 2 ? 'x' : 0x1b);
    seal(bytes);
    EXPECT_EQ(good(bytes).monitorName, "xx???????????");
}

TEST(EdidTest, AnAspectRatioIsNoSize) {
    Bytes bytes = syntheticEdid("TV", 1920, 1080);
    bytes[66] = std::byte{16};
    bytes[67] = std::byte{9};
    bytes[22] = std::byte{0};
    seal(bytes);
    EXPECT_EQ(good(bytes).widthM, 0);
}

TEST(EdidTest, InterlacedHeightIsTheFrames) {
    Bytes bytes = syntheticEdid("CRT", 1920, 540);
    bytes[71] = std::byte{0x9e};
    seal(bytes);
    EXPECT_TRUE(good(bytes).interlaced);
    EXPECT_EQ(good(bytes).nativeHeight, 1080);
}

TEST(EdidTest, SaysWhatIsWrong) {
    EXPECT_EQ(errorOf({}), "edid: 0 bytes are no whole blocks of 128 (allowed 1 to 256 blocks)");
    EXPECT_NE(errorOf(Bytes(257UL * 128)).find("32896 bytes"), std::string::npos);
    EXPECT_EQ(errorOf(Bytes(128)), "edid: byte 1 is no EDID header's");
    Bytes bytes = syntheticEdid("a", 800, 600);
    bytes[40] ^= std::byte{3};
    EXPECT_EQ(errorOf(bytes), "edid: checksum of the base block is 3, not 0");
    bytes = syntheticEdid("a", 800, 600);
    bytes[18] = std::byte{2};
    seal(bytes);
    EXPECT_EQ(errorOf(bytes), "edid: version 2 (allowed 1)");
}

TEST(EdidTest, ABadExtensionLeavesTheBaseGood) {
    Bytes bytes = bytesOfHex(kDell);
    bytes[200] ^= std::byte{1};
    Edid edid = good(bytes);
    EXPECT_FALSE(edid.cea);
    ASSERT_EQ(edid.faults.size(), 1U);
    EXPECT_NE(edid.faults[0].find("checksum"), std::string::npos);

    bytes.resize(128);
    edid = good(bytes);
    EXPECT_EQ(edid.nativeWidth, 1920);
    EXPECT_EQ(edid.faults,
              std::vector<std::string>{"1 extension blocks are announced, 0 are there"});

    bytes = bytesOfHex(kDell);
    bytes[128 + 4] = std::byte{0x5f}; // 31 bytes, the collection ends before
    seal(bytes, 1);
    EXPECT_EQ(good(bytes).faults.size(), 1U);
    bytes[128 + 2] = std::byte{200};
    seal(bytes, 1);
    EXPECT_EQ(good(bytes).faults.size(), 1U);
}

TEST(EdidTest, EveryTruncationIsAnErrorOrAFault) {
    for (const std::string_view hex : {kDell, kLg, kBoe}) {
        const Bytes whole = bytesOfHex(hex);
        for (std::size_t size = 0; size < whole.size(); ++size) {
            // A buffer of exactly this size, so that a sanitizer sees a byte too many.
            const auto parsed = parseEdid(Bytes(whole.data(), whole.data() + size));
            if (size == 128)
                EXPECT_EQ(std::get<Edid>(parsed).faults.size(), 1U);
            else
                EXPECT_TRUE(std::holds_alternative<EdidError>(parsed)) << size;
        }
    }
}

TEST(EdidTest, FlippedBytesDoNoHarm) {
    std::mt19937 random(2012);
    for (int round = 0; round < 400; ++round) {
        Bytes bytes = bytesOfHex(round % 2 == 0 ? kDell : kLg);
        for (int flips = 1 + round % 3; flips > 0; --flips)
            bytes[8 + random() % 248] ^= static_cast<std::byte>(1U << random() % 8);
        if (round % 4 >= 2) { // past the checksums
            seal(bytes, 0);
            seal(bytes, 1);
        }
        const auto parsed = parseEdid(bytes);
        if (const auto* edid = std::get_if<Edid>(&parsed)) {
            EXPECT_LE(edid->monitorName.size(), 13U);
            EXPECT_LE(edid->nativeWidth, 4095);
            EXPECT_LE(edid->nativeHeight, 2 * 4095);
        } else {
            EXPECT_FALSE(std::get<EdidError>(parsed).text.empty());
        }
    }
}

} // namespace
} // namespace autostereo::test

#include "devices/kinect2/calibration.hpp"

#include "devices/input.hpp"
#include "tests/support/kinect2_unit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace autostereo::test {
namespace {

using namespace devices;
using namespace devices::kinect2;

template<class T>
void patch(Bytes& bytes, std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

template<class Parse>
std::string refusal(const Parse& parse, const Bytes& page) {
    try {
        static_cast<void>(parse(page));
    } catch (const DeviceError& error) {
        return error.what();
    }
    return {};
}

constexpr std::size_t kTablesEnd = 32 + 3 * (4 + 2 * kPixels);
constexpr std::size_t kDefectCountAt = kTablesEnd + 12 + 4;

TEST(PhasePage, IsReadWhole) {
    Kinect2Unit unit = inventedUnit();
    unit.defects = {{0, 1}, {423, 510}};
    const auto calibration = parsePhasePage(phasePage(unit));
    EXPECT_EQ(calibration.offsets, unit.offsets);
    EXPECT_TRUE(calibration.ownAmplitudeFactors);
    EXPECT_DOUBLE_EQ(calibration.amplitudeFactors[0], 41.0 / 31);
    EXPECT_DOUBLE_EQ(calibration.amplitudeFactors[1], 1);
    EXPECT_DOUBLE_EQ(calibration.amplitudeFactors[2], 50.0 / 31);
    EXPECT_EQ(calibration.defects, (std::vector<std::uint32_t>{1, 423 * 512 + 510}));
    EXPECT_EQ(calibration.note, "");
}

TEST(PhasePage, WithoutMultipliersUsesTheUsualOnes) {
    Kinect2Unit unit = inventedUnit();
    unit.multipliers = {0, 0, 0};
    const auto calibration = parsePhasePage(phasePage(unit));
    EXPECT_FALSE(calibration.ownAmplitudeFactors);
    EXPECT_NEAR(calibration.amplitudeFactors[0], 1.322581, 1e-6);
    EXPECT_NEAR(calibration.amplitudeFactors[2], 1.612903, 1e-6);
}

TEST(PhasePage, AnOddTailIsLeftOutAndSaid) {
    const Bytes good = phasePage(inventedUnit());
    Bytes many = good, outside = good, cut = good;
    patch<std::uint16_t>(many, kDefectCountAt, 71);
    patch<std::uint16_t>(outside, kDefectCountAt, 1);
    patch<std::uint16_t>(outside, kDefectCountAt + 2, 424);
    cut.resize(kTablesEnd + 10);
    for (const Bytes& page : {many, outside, cut}) {
        const auto calibration = parsePhasePage(page);
        EXPECT_TRUE(calibration.defects.empty());
        EXPECT_NE(calibration.note, "");
    }
}

TEST(PhasePage, WrongSizesAreRefused) {
    Bytes page = phasePage(inventedUnit());
    page.resize(kTablesEnd - 1);
    EXPECT_NE(refusal(parsePhasePage, page).find("1302571 bytes, 1302572 are needed"),
              std::string::npos)
        << refusal(parsePhasePage, page);
    EXPECT_NE(refusal(parsePhasePage, {}), "");
    for (const std::size_t field : {0U, 12U}) { // header, table
        Bytes odd = phasePage(inventedUnit());
        patch<std::uint32_t>(odd, field, 31);
        EXPECT_NE(refusal(parsePhasePage, odd).find("instead of 32 and 434176"), std::string::npos);
    }
}

TEST(DepthCameraPage, PixelCentresAreAtIntegers) {
    Kinect2Unit unit = inventedUnit();
    unit.p1 = 0.001F;
    unit.p2 = -0.002F;
    unit.zOffsetMm = 2.5F;
    const auto camera = parseDepthCameraPage(depthCameraPage(unit));
    EXPECT_EQ(camera.zOffsetMm, 2.5);
    for (const auto& [x, y] : {std::pair{1, 0}, {255, 212}, {510, 423}}) {
        const auto ray = camera.model.unproject({x, y});
        const auto expected = rayOf(unit, x, y);
        ASSERT_TRUE(ray);
        EXPECT_NEAR(ray->x, expected[0], 1e-9);
        EXPECT_NEAR(ray->y, expected[1], 1e-9);
    }
}

TEST(DepthCameraPage, NumbersThatCannotBeAreRefused) {
    constexpr std::size_t kFx = 0, kCy = 16, kK1 = 20, kZOffset = 88;
    const Bytes good = depthCameraPage(inventedUnit());
    EXPECT_EQ(refusal(parseDepthCameraPage, good), "");
    EXPECT_NE(refusal(parseDepthCameraPage, Bytes(91)), "");
    for (const std::size_t field : {kFx, kCy, kK1, kZOffset})
        for (const float bad : {NAN, std::numeric_limits<float>::infinity()}) {
            Bytes page = good;
            patch(page, field, bad);
            EXPECT_NE(refusal(parseDepthCameraPage, page), "") << field;
        }
    Bytes page = good;
    patch(page, kZOffset, 200.0F);
    EXPECT_NE(refusal(parseDepthCameraPage, page).find("allowed -100 to 100"), std::string::npos);
}

TEST(ColorPage, IsReadWhole) {
    Kinect2Unit unit = inventedUnit();
    unit.irCentroids[22][27] = {1, 2};
    unit.colorCentroids[0][1] = {3, 4};
    unit.checkDepthsMm[22][27] = 5;
    const auto calibration = parseColorPage(colorPage(unit));
    EXPECT_FLOAT_EQ(static_cast<float>(calibration.focal), unit.colorFocal);
    EXPECT_EQ(calibration.displacementMm, 52);
    EXPECT_FLOAT_EQ(static_cast<float>(calibration.xTerms[7]), unit.xTerms[7]);
    EXPECT_FLOAT_EQ(static_cast<float>(calibration.yTerms[9]), unit.yTerms[9]);
    EXPECT_EQ(calibration.irCentroids[22][27].y, 2);
    EXPECT_EQ(calibration.colorCentroids[0][1].x, 3);
    EXPECT_EQ(calibration.checkDepthsMm[22][27], 5);
}

TEST(ColorPage, WhatCannotBeIsRefused) {
    const Bytes good = colorPage(inventedUnit());
    EXPECT_EQ(refusal(parseColorPage, good), "");
    Bytes cut = good, version = good, focal = good, term = good;
    cut.pop_back();
    version[0] = std::byte{2};
    patch(focal, 1, 0.0F);
    patch(term, 1 + 20 + 4 * 12, NAN);
    for (const Bytes& page : {cut, version, focal, term})
        EXPECT_NE(refusal(parseColorPage, page), "");
}

} // namespace
} // namespace autostereo::test

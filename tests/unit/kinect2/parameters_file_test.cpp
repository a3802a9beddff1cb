#include "devices/kinect2/parameters_file.hpp"

#include "devices/input.hpp"
#include "tests/support/kinect2_unit.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace autostereo::test {
namespace {

using namespace devices::kinect2;
using nlohmann::json;

/// The numbers of the unit's pages as libfreenect2 hands them out.
json fileOf(const Kinect2Unit& unit) {
    constexpr std::array kTerms{"x3y0", "x0y3", "x2y1", "x1y2", "x2y0",
                                "x0y2", "x1y1", "x1y0", "x0y1", "x0y0"};
    json file;
    file["ir"] = {{"fx", unit.fx}, {"fy", unit.fy}, {"cx", unit.cx},
                  {"cy", unit.cy}, {"k1", unit.k1}, {"k2", unit.k2},
                  {"k3", unit.k3}, {"p1", unit.p1}, {"p2", unit.p2}};
    file["color"] = {{"fx", unit.colorFocal},
                     {"fy", unit.colorFocal},
                     {"cx", unit.colorCx},
                     {"cy", unit.colorCy},
                     {"shift_d", unit.nominalDepthMm},
                     {"shift_m", unit.displacementMm}};
    for (std::size_t i = 0; i < kTerms.size(); ++i) {
        file["color"][std::string("mx_") + kTerms[i]] = unit.xTerms[i];
        file["color"][std::string("my_") + kTerms[i]] = unit.yTerms[i];
    }
    return file;
}

std::string complaintAbout(const json& file) {
    try {
        static_cast<void>(readParameters(file.dump(), "unit.json"));
    } catch (const devices::DeviceError& error) {
        return error.what();
    }
    return {};
}

TEST(ParametersFile, SaysWhatThePagesSay) {
    const Kinect2Unit unit = inventedUnit();
    const Parameters read = readParameters(fileOf(unit).dump(), "unit.json");
    const DepthCamera depth = parseDepthCameraPage(depthCameraPage(unit));
    const ColorCalibration color = parseColorPage(colorPage(unit));
    const auto numbersOf = [](const calib::CameraModel& model) {
        const auto& [width, height, fx, fy, cx, cy] = model.intrinsics;
        const auto& k = model.distortion;
        return std::array{1.0 * width, 1.0 * height, fx, fy, cx, cy, k.k1, k.k2, k.p1, k.p2, k.k3};
    };
    EXPECT_EQ(numbersOf(read.depth.model), numbersOf(depth.model));
    EXPECT_EQ(read.color.focal, color.focal);
    EXPECT_EQ(read.color.cx, color.cx);
    EXPECT_EQ(read.color.cy, color.cy);
    EXPECT_EQ(read.color.nominalDepthMm, color.nominalDepthMm);
    EXPECT_EQ(read.color.displacementMm, color.displacementMm);
    EXPECT_EQ(read.color.xTerms, color.xTerms);
    EXPECT_EQ(read.color.yTerms, color.yTerms);
}

TEST(ParametersFile, ComplaintsNameFileAndKey) {
    json file = fileOf(inventedUnit());
    EXPECT_EQ(complaintAbout(file), "");
    file["color"]["mx_x2y1"] = "much";
    EXPECT_EQ(complaintAbout(file), "unit.json: color.mx_x2y1: is no number");
    file["color"].erase("mx_x2y1");
    EXPECT_EQ(complaintAbout(file), "unit.json: color.mx_x2y1: missing (a number is needed)");
    file = fileOf(inventedUnit());
    file["color"]["shift_m"] = 1e9;
    EXPECT_EQ(complaintAbout(file), "unit.json: color.shift_m = 1000000000.000000 (allowed "
                                    "-500.000000 to 500.000000)");
    file["ir"] = 3;
    EXPECT_EQ(complaintAbout(file), "unit.json: ir.fx: missing (a number is needed)");
    file = fileOf(inventedUnit());
    file["ir"]["fx"] = 0;
    EXPECT_NE(complaintAbout(file).find("unit.json: ir."), std::string::npos);
    EXPECT_NE(complaintAbout(json::array()).find("is no JSON object"), std::string::npos);
    EXPECT_THROW(static_cast<void>(readParameters("{", "unit.json")), devices::DeviceError);
}

} // namespace
} // namespace autostereo::test

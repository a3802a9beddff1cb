#include "daemon/find_display.hpp"

#include "tests/support/data.hpp"
#include "tests/support/edid_bytes.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace autostereo::daemon {
namespace {

constexpr const char* kGood = R"({"configVersion": "3.0", "serial": "LKG-P00042",
"pitch": {"value": 52.5}, "slope": {"value": -7.1}, "center": {"value": 0.47},
"viewCone": {"value": 40}, "invView": {"value": 1}, "DPI": {"value": 324},
"screenW": {"value": 1536}, "screenH": {"value": 2048}, "flipImageX": {"value": 0},
"flipImageY": {"value": 0}, "flipSubp": {"value": 0}})";
constexpr const char* kZeros = R"({"serial": "LKG-P00042", "pitch": {"value": 0},
"slope": {"value": 0}, "center": {"value": 0}, "viewCone": {"value": 0}, "DPI": {"value": 0},
"screenW": {"value": 0}, "screenH": {"value": 0}})";

/// A machine with one Looking Glass on HDMI, whose calibration lies in the vendor's cache.
class FindDisplay : public testing::Test {
  protected:
    void SetUp() override {
        places_.root = scratch_.path() / "root";
        places_.home = "/home/kiosk"; // below the root, as all is
        places_.state = scratch_.path() / "state";
        places_.usb = false;
        const auto connector = places_.root / "sys/class/drm/card0-HDMI-A-1";
        write(connector / "status", "connected\n");
        write(connector / "enabled", "enabled\n");
        write(connector / "modes", "1536x2048\n");
        const auto edid = test::syntheticEdid("LKG01Do12HjQE", 1536, 2048);
        write(connector / "edid",
              std::string(reinterpret_cast<const char*>(edid.data()), edid.size()));
    }
    static void write(const std::filesystem::path& file, const std::string& text) {
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
    }
    void giveCalibration(const std::string& text) const {
        write(places_.root / "home/kiosk/.local/share/LookingGlass/Bridge/Locations/LKG-P00042" /
                  "LKG_calibration/visual.json",
              text);
    }

    test::ScratchFolder scratch_;
    DisplayPlaces places_;
};

TEST_F(FindDisplay, aLookingGlassWithItsOwnCalibration) {
    giveCalibration(kGood);
    const FoundDisplay found = findDisplay(places_);
    ASSERT_TRUE(found.profile);
    EXPECT_EQ(found.connector, "HDMI-A-1");
    EXPECT_EQ(std::get<calib::LookingGlassCalibration>(found.profile->law).pitch, 52.5);
    EXPECT_FALSE(found.profile->placeholder);
    EXPECT_TRUE(std::filesystem::exists(places_.state / "calibrations/LKG-P00042.json"));
}

TEST_F(FindDisplay, zerosAreRefusedAndTheLastGoodOneStandsIn) {
    giveCalibration(kGood);
    static_cast<void>(findDisplay(places_));
    giveCalibration(kZeros);
    const FoundDisplay found = findDisplay(places_);
    ASSERT_TRUE(found.profile);
    EXPECT_EQ(std::get<calib::LookingGlassCalibration>(found.profile->law).pitch, 52.5);
    EXPECT_FALSE(found.warnings.empty());
}

TEST_F(FindDisplay, withoutAnyCalibrationTheTemplateByEdidAndSize) {
    const FoundDisplay found = findDisplay(places_);
    ASSERT_TRUE(found.profile);
    EXPECT_TRUE(found.profile->placeholder);
    EXPECT_EQ(found.profile->width, 1536);
}

TEST_F(FindDisplay, aPlainMonitorIsNothing) {
    std::filesystem::remove(places_.root / "sys/class/drm/card0-HDMI-A-1/edid");
    const FoundDisplay found = findDisplay(places_);
    EXPECT_FALSE(found.profile);
    EXPECT_EQ(found.connector, "");
}

} // namespace
} // namespace autostereo::daemon

#include "gpu/monitor_choice.hpp"

#include "gpu/gl/error.hpp"

#include <gtest/gtest.h>

namespace autostereo::test {
namespace {

using namespace gpu;

std::string nameOf(std::string_view connector, const std::vector<std::string>& names) {
    const auto index = monitorOfConnector(connector, names);
    return index ? names.at(*index) : "none";
}

TEST(MonitorOfConnector, EachDriversWords) {
    const std::vector<std::string> wayland{"eDP-1", "HDMI-A-1", "DP-1", "DP-2"};
    EXPECT_EQ(nameOf("HDMI-A-1", wayland), "HDMI-A-1");
    EXPECT_EQ(nameOf("DP-2", wayland), "DP-2");
    EXPECT_EQ(nameOf("eDP-1", wayland), "eDP-1");

    const std::vector<std::string> modesetting{"eDP-1", "HDMI-1", "HDMI-2", "DP-1", "DVI-D-1"};
    EXPECT_EQ(nameOf("HDMI-A-1", modesetting), "HDMI-1");
    EXPECT_EQ(nameOf("HDMI-A-2", modesetting), "HDMI-2");
    EXPECT_EQ(nameOf("DVI-D-1", modesetting), "DVI-D-1");
    EXPECT_EQ(nameOf("HDMI-A-3", modesetting), "none");
    EXPECT_EQ(nameOf("HDMI-B-1", modesetting), "none");

    const std::vector<std::string> intel{"eDP1", "HDMI1", "DP1"};
    EXPECT_EQ(nameOf("HDMI-A-1", intel), "HDMI1");
    EXPECT_EQ(nameOf("DP-1", intel), "DP1");

    const std::vector<std::string> amdgpu{"eDP", "HDMI-A-0", "HDMI-A-1", "DisplayPort-0"};
    EXPECT_EQ(nameOf("HDMI-A-1", amdgpu), "HDMI-A-0");
    EXPECT_EQ(nameOf("HDMI-A-2", amdgpu), "HDMI-A-1");
    EXPECT_EQ(nameOf("DP-1", amdgpu), "DisplayPort-0");
    EXPECT_EQ(nameOf("eDP-1", amdgpu), "eDP");
    EXPECT_EQ(nameOf("DP-2", {"DisplayPort-1"}), "DisplayPort-1");

    const std::vector<std::string> nvidia{"HDMI-0", "DP-0", "DP-1"};
    EXPECT_EQ(nameOf("HDMI-A-1", nvidia), "HDMI-0");
    EXPECT_EQ(nameOf("DP-2", nvidia), "DP-1");
}

TEST(MonitorOfConnector, SecondCardUnderX) {
    EXPECT_EQ(nameOf("HDMI-A-1", {"eDP-1", "HDMI-1-1"}), "HDMI-1-1");
    EXPECT_EQ(nameOf("HDMI-A-1", {"HDMI-1", "HDMI-1-1"}), "none") << "two cards have one each";
    EXPECT_EQ(nameOf("HDMI-A-1", {"HDMI-1-2"}), "none");
}

TEST(MonitorOfConnector, OddNames) {
    for (const char* name :
         {"", "-", "1", "screen", "HDMI", "HDMI-99999999999", "Dell Inc. 27\""}) {
        EXPECT_EQ(nameOf("HDMI-A-2", {name}), "none") << name;
        EXPECT_EQ(nameOf(name, {"HDMI-2"}), "none") << name;
    }
    EXPECT_EQ(nameOf("HDMI-A-1", {}), "none");
}

const std::vector<MonitorInfo> kMonitors{
    {"eDP-1", 1920, 1080, 60}, {"HDMI-1", 1536, 2048, 60}, {"HDMI-2", 1920, 1080, 60}};

std::string errorOf(const std::vector<MonitorInfo>& monitors, const MonitorRequest& request) {
    try {
        return "took " + monitors.at(chooseMonitor(monitors, request).index).name;
    } catch (const DisplayNotFound& error) {
        return error.what();
    }
}

TEST(ChooseMonitor, BySizeThePrimaryFirst) {
    EXPECT_EQ(errorOf(kMonitors, {}), "took eDP-1");
    EXPECT_EQ(errorOf(kMonitors, {1920, 1080, "", false}), "took eDP-1");
    EXPECT_EQ(errorOf(kMonitors, {1536, 2048, "", false}), "took HDMI-1");
    EXPECT_EQ(errorOf(kMonitors, {2560, 1440, "", true}), "took eDP-1");
    EXPECT_NE(errorOf(kMonitors, {2560, 1440, "", false}).find("HDMI-1 1536x2048"),
              std::string::npos);
    EXPECT_NE(errorOf({}, {}).find("no monitor"), std::string::npos);
}

TEST(ChooseMonitor, ByConnectorFirst) {
    EXPECT_EQ(errorOf(kMonitors, {1920, 1080, "HDMI-A-2", false}), "took HDMI-2");
    EXPECT_EQ(errorOf(kMonitors, {0, 0, "HDMI-A-1", false}), "took HDMI-1");
    const std::string wrongMode = errorOf(kMonitors, {1920, 1080, "HDMI-A-1", false});
    EXPECT_NE(wrongMode.find("HDMI-A-1 is in mode 1536x2048"), std::string::npos) << wrongMode;
    EXPECT_NE(wrongMode.find("--force"), std::string::npos);
    EXPECT_EQ(errorOf(kMonitors, {1920, 1080, "HDMI-A-1", true}), "took HDMI-1");
}

TEST(ChooseMonitor, AConnectorWithoutAName) {
    EXPECT_NE(errorOf(kMonitors, {1920, 1080, "DP-1", false}).find("cannot tell"),
              std::string::npos)
        << "two have that size";
    const auto choice = chooseMonitor(kMonitors, {1536, 2048, "DP-1", false});
    EXPECT_EQ(choice.index, 1U);
    EXPECT_NE(choice.warning.find("taking HDMI-1"), std::string::npos);
    EXPECT_EQ(chooseMonitor(kMonitors, {1920, 1080, "HDMI-A-2", false}).warning, "");
}

TEST(MonitorChange, OnlyWhatMovesSubPixelsCounts) {
    const MonitorInfo was{"HDMI-A-1", 3840, 2160, 60};
    EXPECT_EQ(monitorChange(was, MonitorInfo{"HDMI-A-1", 3840, 2160, 30}), std::nullopt);
    EXPECT_EQ(monitorChange(was, MonitorInfo{"HDMI-A-1", 1920, 1080, 60}),
              "the monitor HDMI-A-1 went from 3840x2160 to 1920x1080");
    EXPECT_EQ(monitorChange(was, std::nullopt), "the monitor HDMI-A-1 was unplugged or turned off");
}

} // namespace
} // namespace autostereo::test

#include "config/load.hpp"
#include "tests/unit/config/temp_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace autostereo::config {
namespace {

std::string refusal(const std::string& name, const std::string& value) {
    return test::messageOf<ConfigError>([&] { (void)changed(Config{}, name, value); });
}

TEST(ChangeConfig, EverySettingArrivesAndNothingElseMoves) {
    Config config;
    config.input = "kitchen.mkv";
    config.rig = "kitchen.toml";
    config = changed(config, "scale", "0.5");
    config = changed(config, "focus", "1.25");
    config = changed(config, "method", "multipass");
    config = changed(config, "brightness", "0.2");
    config = changed(config, "mode", "2d");
    EXPECT_EQ(config.pipeline.budget.depthScale, 0.5);
    EXPECT_EQ(config.pipeline.budget.focusM, 1.25);
    EXPECT_EQ(config.pipeline.synthesis.method, gpu::Method::Multipass);
    EXPECT_EQ(config.brightness, 0.2);
    EXPECT_TRUE(config.flat);
    EXPECT_EQ(config.input, "kitchen.mkv");
    EXPECT_EQ(config.rig, "kitchen.toml");

    config = changed(config, "scale", "auto");
    config = changed(config, "mode", "3d");
    EXPECT_FALSE(config.pipeline.budget.depthScale);
    EXPECT_EQ(config.pipeline.budget.focusM, 1.25);
    EXPECT_FALSE(config.flat);
}

TEST(ChangeConfig, RefusalsAreThoseOfFiles) {
    EXPECT_EQ(refusal("scale", "11"),
              "set scale: depth.scale: 11 is out of range (allowed 0 to 10)");
    EXPECT_EQ(refusal("scale", "nan"), "set scale: depth.scale: is a string, wanted \"auto\" or a "
                                       "number (allowed 0 to 10)");
    EXPECT_EQ(refusal("brightness", ""), "set brightness: picture.brightness: is a string, wanted "
                                         "a number (allowed 0 to 1)");
    EXPECT_EQ(refusal("mode", "4d"), "set mode: picture.mode: \"4d\" is unknown (allowed 3d, 2d)");
    EXPECT_EQ(refusal("gamma", "1"),
              "set gamma: unknown (allowed scale, focus, method, brightness, mode)");
}

// What is set is a value and nothing but a value.
TEST(ChangeConfig, ValuesStartNoKeysOfTheirOwn) {
    for (const char* value : {"1\n[input]\nuri = \"other\"", "\"\ninput.uri = \"x", "\\", "'",
                              "{ a = 1 }", "[1, 2]", "true", "1979-05-27"}) {
        const std::string message = refusal("mode", value);
        EXPECT_TRUE(message.starts_with("set mode: picture.mode: \"")) << message;
        EXPECT_NE(message.find("is unknown (allowed 3d, 2d)"), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos);
    }
}

} // namespace
} // namespace autostereo::config

#include "devices/display/calibration_cache.hpp"

#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace autostereo::test {
namespace {

using namespace devices;
using Origin = ChosenCalibration::Origin;

/// All zeros are no calibration.
std::optional<std::string> zeros(std::string_view text) {
    if (text.find_first_not_of('0') == std::string_view::npos) return "all zeros";
    return std::nullopt;
}

class CalibrationCacheTest : public testing::Test {
  protected:
    [[nodiscard]] std::size_t filesInCache() const {
        std::size_t count = 0;
        for ([[maybe_unused]] const auto& entry :
             std::filesystem::directory_iterator(folder / "state"))
            ++count;
        return count;
    }
    ScratchFolder folder;
    CalibrationCache cache{folder / "state"};
};

TEST_F(CalibrationCacheTest, FileNames) {
    const auto name = [](std::string_view serial) { return CalibrationCache::fileName(serial); };
    EXPECT_EQ(name("LKG-PORT-02283"), "LKG-PORT-02283.json");
    EXPECT_EQ(name("../../etc/passwd"), "------etc-passwd.json");
    EXPECT_EQ(name(std::string("a\0b", 3)), "a-b.json");
    EXPECT_EQ(name("\xc3\xa4x"), "--x.json");
    EXPECT_EQ(name(std::string(100, 'x')), std::string(64, 'x') + ".json");
    EXPECT_FALSE(name(""));
    EXPECT_FALSE(name("../.."));
}

TEST_F(CalibrationCacheTest, KeepsAndReplaces) {
    EXPECT_FALSE(cache.load("LKG-1"));
    EXPECT_FALSE(cache.store("LKG-1", "one"));
    EXPECT_FALSE(cache.store("LKG-2", "two"));
    EXPECT_EQ(cache.load("LKG-1"), "one");
    EXPECT_FALSE(cache.store("LKG-1", "a new one"));
    EXPECT_EQ(cache.load("LKG-1"), "a new one");
    EXPECT_EQ(cache.load("LKG-2"), "two");
    EXPECT_EQ(filesInCache(), 2U) << "no temporary file stays";
}

TEST_F(CalibrationCacheTest, FailuresAreTold) {
    EXPECT_NE(cache.store("", "x").value_or("").find("no letters"), std::string::npos);
    EXPECT_TRUE(cache.store("a", std::string(CalibrationCache::kMostBytes + 1, 'x')));
    EXPECT_FALSE(cache.load("a"));
    folder.write("file", "");
    const CalibrationCache impossible(folder / "file");
    EXPECT_NE(impossible.store("a", "x").value_or("").find((folder / "file").string()),
              std::string::npos);
    std::filesystem::create_directories(folder / "state/b.json/full");
    EXPECT_TRUE(cache.store("b", "x")) << "a folder is in the place of the file";
    EXPECT_EQ(filesInCache(), 1U);
    EXPECT_FALSE(cache.load("b"));
}

TEST_F(CalibrationCacheTest, WhatAKilledProcessLeftIsNeitherReadNorKept) {
    ASSERT_FALSE(cache.store("LKG-1", "whole"));
    const auto old = folder.write("state/LKG-1.json.new-aBcDeF", "hal");
    const auto young = folder.write("state/LKG-1.json.new-ghIjKl", "ha");
    const auto other = folder.write("state/LKG-10.json", "other");
    std::filesystem::last_write_time(old, std::filesystem::file_time_type::clock::now() -
                                              std::chrono::hours(1));
    EXPECT_EQ(cache.load("LKG-1"), "whole");
    EXPECT_FALSE(cache.store("LKG-1", "new"));
    EXPECT_EQ(cache.load("LKG-1"), "new");
    EXPECT_FALSE(std::filesystem::exists(old));
    EXPECT_TRUE(std::filesystem::exists(young)) << "it may be another process's at work";
    EXPECT_TRUE(std::filesystem::exists(other));
}

TEST_F(CalibrationCacheTest, ReadersNeverSeeHalfAText) {
    const std::string a(200'000, 'a');
    const std::string b(200'000, 'b');
    ASSERT_FALSE(cache.store("LKG-1", a));
    std::jthread writer([&](const std::stop_token& stop) {
        for (int i = 0; i < 60 && !stop.stop_requested(); ++i)
            EXPECT_FALSE(cache.store("LKG-1", i % 2 == 0 ? b : a));
    });
    for (int i = 0; i < 300; ++i) {
        const auto seen = cache.load("LKG-1");
        ASSERT_TRUE(seen == a || seen == b) << i;
    }
}

TEST_F(CalibrationCacheTest, AGoodFreshOneIsUsedAndKept) {
    const auto chosen = chooseCalibration("LKG-1", "1234", zeros, cache);
    EXPECT_EQ(chosen.origin, Origin::Fresh);
    EXPECT_EQ(chosen.text, "1234");
    EXPECT_TRUE(chosen.warnings.empty());
    EXPECT_EQ(cache.load("LKG-1"), "1234");

    const auto file = folder / "state/LKG-1.json";
    const auto written = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1);
    std::filesystem::last_write_time(file, written);
    EXPECT_EQ(chooseCalibration("LKG-1", "1234", zeros, cache).origin, Origin::Fresh);
    EXPECT_EQ(std::filesystem::last_write_time(file), written) << "the same is not written again";
}

TEST_F(CalibrationCacheTest, ZerosFallBackToTheLastGoodOne) {
    ASSERT_FALSE(cache.store("LKG-1", "1234"));
    for (const auto& fresh : {std::optional<std::string>("0000"), std::optional<std::string>()}) {
        const auto chosen = chooseCalibration("LKG-1", fresh, zeros, cache);
        EXPECT_EQ(chosen.origin, Origin::Cached);
        EXPECT_EQ(chosen.text, "1234");
        ASSERT_EQ(chosen.warnings.size(), 1U);
        EXPECT_NE(chosen.warnings[0].find(fresh ? "all zeros" : "gives no calibration"),
                  std::string::npos);
        EXPECT_EQ(cache.load("LKG-1"), "1234") << "zeros are never kept";
    }
}

TEST_F(CalibrationCacheTest, NothingGoodAtAll) {
    auto chosen = chooseCalibration("LKG-1", std::nullopt, zeros, cache);
    EXPECT_EQ(chosen.origin, Origin::None);
    EXPECT_EQ(chosen.text, "");
    EXPECT_EQ(chosen.warnings.size(), 1U);
    ASSERT_FALSE(cache.store("LKG-1", "000"));
    chosen = chooseCalibration("LKG-1", "00", zeros, cache);
    EXPECT_EQ(chosen.origin, Origin::None);
    EXPECT_NE(chosen.warnings.at(0).find("neither is the one that was kept"), std::string::npos);
}

TEST_F(CalibrationCacheTest, AFullDiskIsAWarningOnly) {
    folder.write("file", "");
    const CalibrationCache impossible(folder / "file");
    const auto chosen = chooseCalibration("LKG-1", "1", zeros, impossible);
    EXPECT_EQ(chosen.origin, Origin::Fresh);
    EXPECT_EQ(chosen.warnings.size(), 1U);
}

} // namespace
} // namespace autostereo::test

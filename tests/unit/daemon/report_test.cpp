#include "daemon/session/report.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace autostereo::daemon {
namespace {

namespace fs = std::filesystem;

/// What a run of 100 pairs leaves, of which the report takes all its numbers.
Report exampleReport() {
    Report report;
    report.input = "sim:person";
    report.display = "looking-glass-portrait";
    report.renderer = "llvmpipe \"quoted\"";
    report.feed.depth = {110, 100, 10, 1, 2, 3};
    report.feed.color = {120, 100, 20, 0, 4, 5};
    report.feed.pairs = 100;
    report.feed.dropped = 7;
    report.presented = 88;
    report.skipped = {{"hidden", 2}, {"unchanged", 3}};
    report.withoutDepth = 6;
    report.stageNames = {"upload", "mesh"};
    report.stageMs.resize(2);
    for (int i = 0; i <= 100; ++i)
        report.stageMs[0].add(i);
    report.conditioner = {{"held", 90000.5}, {"flying", 300}};
    report.method = "direct";
    report.gpuMemoryMib = 20.5;
    report.gpuObjects = 120;
    report.depth = {1.25, 0.5, 0.125};
    report.latencyMs.add(42);
    report.latencyHistogram.add(42);
    for (const double ms : {1.0, 2.0, 3.0})
        report.latencyParts.transfer.add(ms);
    report.seconds = 4;
    report.recording = devices::Recorder::Counters{9, 1, 123456, ""};
    report.keptShare = 0.75;
    report.keptPicture = 0.5;
    report.keptColor = 0.25;
    report.colorWay = "filled";
    return report;
}

class ReportFile : public ::testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "report.XXXXXX").string();
        ASSERT_NE(mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] const fs::path& folder() const { return folder_; }
    [[nodiscard]] std::ptrdiff_t filesLeft() const {
        return std::distance(fs::directory_iterator(folder_), {});
    }
    [[nodiscard]] std::string writtenText(const Report& report) const {
        writeReport(report, folder_ / "report.json");
        std::ifstream in(folder_ / "report.json");
        return {std::istreambuf_iterator<char>(in), {}};
    }
    [[nodiscard]] nlohmann::json written(const Report& report) const {
        return nlohmann::json::parse(writtenText(report));
    }

  private:
    fs::path folder_;
};

TEST_F(ReportFile, HasTheFieldsOfTheContract) {
    const auto expected = nlohmann::json::parse(R"({
        "input": "sim:person",
        "display": "looking-glass-portrait",
        "renderer": "llvmpipe \"quoted\"",
        "method": "direct",
        "streams": {
            "depth": {"in": 110, "paired": 100, "unpaired": 10, "pending": 1, "damaged": 2,
                      "reconnects": 3},
            "color": {"in": 120, "paired": 100, "unpaired": 20, "pending": 0, "damaged": 4,
                      "reconnects": 5}
        },
        "frames_in": 100,
        "frames_presented": 88,
        "frames_skipped": 5,
        "frames_dropped": 7,
        "frames_without_depth": 6,
        "skipped": {"hidden": 2, "unchanged": 3},
        "conditioner": {"held": 90000.5, "flying": 300.0},
        "depth": {"focus_m": 1.25, "scale": 0.5, "clamped_share": 0.125},
        "recording": {"written": 9, "left_out": 1, "bytes": 123456, "error": ""},
        "search_kept_share": 0.75,
        "picture_kept_share": 0.5,
        "fusion_kept_share": null,
        "color_kept_share": 0.25,
        "color_way": "filled",
        "stages": {
            "upload": {"p50_ms": 50.0, "p99_ms": 99.0},
            "mesh": {"p50_ms": null, "p99_ms": null}
        },
        "gpu": {"memory_mib": 20.5, "objects": 120},
        "latency_ms": {"p50": 42.0, "p99": 42.0},
        "latency_parts_ms": {
            "transfer": {"p50": 2.0, "p99": 3.0, "max": 3.0},
            "pairing": {"p50": null, "p99": null, "max": null},
            "wait": {"p50": null, "p99": null, "max": null},
            "draw": {"p50": null, "p99": null, "max": null},
            "swap": {"p50": null, "p99": null, "max": null}
        },
        "latency_histogram": {
            "up_to_ms": [5.0, 10.0, 15.0, 20.0, 30.0, 40.0, 50.0, 75.0, 100.0, 150.0, 200.0, 300.0,
                         500.0, 1000.0],
            "frames": [0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0]
        },
        "seconds": 4.0
    })");
    EXPECT_EQ(written(exampleReport()), expected);
    EXPECT_EQ(writtenText(exampleReport()).back(), '\n');
}

TEST_F(ReportFile, LatencyIsNullWhereNothingWasTimed) {
    Report report = exampleReport();
    report.latencyMs = {};
    EXPECT_TRUE(written(report)["latency_ms"].is_null());
}

TEST_F(ReportFile, AnEmptyRunIsStillWhole) {
    const nlohmann::json json = written({});
    EXPECT_EQ(json["frames_in"], 0);
    EXPECT_EQ(json["frames_skipped"], 0);
    EXPECT_TRUE(json["stages"].is_object());
    EXPECT_TRUE(json["skipped"].is_object());
    EXPECT_TRUE(json["stages"].empty());
    EXPECT_TRUE(json["skipped"].empty());
}

TEST_F(ReportFile, AccountsBalance) {
    const nlohmann::json json = written(exampleReport());
    const auto number = [&](const char* key) { return json[key].get<int>(); };
    EXPECT_EQ(number("frames_in"),
              number("frames_presented") + number("frames_skipped") + number("frames_dropped"));
    for (const char* stream : {"depth", "color"}) {
        const nlohmann::json& counts = json["streams"][stream];
        EXPECT_EQ(counts["in"].get<int>(),
                  counts["paired"].get<int>() + counts["unpaired"].get<int>());
    }
}

TEST_F(ReportFile, TakesTheOldOnesPlaceAndLeavesNothingElse) {
    Report report = exampleReport();
    EXPECT_EQ(written(report)["seconds"], 4);
    const fs::path kept = folder() / "kept.json";
    fs::create_hard_link(folder() / "report.json", kept);
    report.seconds = 5;
    EXPECT_EQ(written(report)["seconds"], 5);
    // The old file was never written into: who has it open reads it to its end.
    std::ifstream in(kept);
    EXPECT_EQ(nlohmann::json::parse(in)["seconds"], 4);
    EXPECT_EQ(filesLeft(), 2);
}

TEST_F(ReportFile, SaysWhereItCannotWrite) {
    const auto messageFor = [](const fs::path& file) {
        try {
            writeReport(exampleReport(), file);
        } catch (const std::runtime_error& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    const fs::path missing = folder() / "missing" / "report.json";
    EXPECT_EQ(messageFor(missing),
              "report: cannot write " + missing.string() + ": No such file or directory");
    const fs::path taken = folder() / "taken";
    fs::create_directory(taken);
    EXPECT_EQ(messageFor(taken), "report: cannot write " + taken.string() + ": Is a directory");
    EXPECT_EQ(filesLeft(), 1) << "the unfinished file is left behind";
}

TEST(ReportSummary, IsOneLineForPeople) {
    EXPECT_EQ(exampleReport().summary(), "100 frames in, 88 presented (22.0/s), 5 skipped, "
                                         "7 dropped; upload 50.0 ms; latency 42.0 ms");
    EXPECT_EQ(Report{}.summary(), "0 frames in, 0 presented (0.0/s), 0 skipped, 0 dropped");
}

} // namespace
} // namespace autostereo::daemon

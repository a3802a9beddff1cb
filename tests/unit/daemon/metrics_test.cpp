#include "daemon/session/metrics.hpp"

#include "tests/support/prometheus_text.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace autostereo::daemon {
namespace {

using std::chrono::milliseconds;
using test::prometheusSamples;

Report busyReport() {
    Report report;
    report.display = "glass \"7.9\\\"\nand more";
    report.renderer = "llvmpipe";
    report.method = "direct";
    report.feed.depth = {110, 100, 10, 1, 2, 3};
    report.feed.color = {120, 100, 20, 0, 4, 5};
    report.feed.pairs = 100;
    report.feed.dropped = 7;
    report.presented = std::uint64_t{1} << 53;
    report.skipped = {{"stale", 2}, {"unchanged", 3}};
    report.withoutDepth = 6;
    report.stageNames = {"upload", "mesh"};
    report.stageMs.resize(2);
    report.stageMs[1].add(2.5);
    report.gpuMemoryMib = 1.5;
    report.gpuObjects = 12;
    for (const double ms : {4.0, 5.0, 5.5, 42.0, 5000.0})
        report.latencyHistogram.add(ms);
    report.seconds = 12.5;
    report.recording = devices::Recorder::Counters{9, 1, 123456, ""};
    return report;
}

Status liveStatus() {
    Status status;
    status.shown = "live";
    status.rate = 29.5;
    status.pictureAgeS = 0.25;
    status.now = devices::TimePoint(milliseconds(10'000));
    devices::SensorStatuses sensors;
    sensors.depth = {devices::SensorState::Streaming, status.now - milliseconds(20), ""};
    sensors.color = {devices::SensorState::Lost, std::nullopt, "unplugged"};
    status.sensors = sensors;
    status.httpRefused = {{401, 3}, {503, 1}};
    return status;
}

TEST(Metrics, EveryFigureIsWhereItBelongs) {
    const auto samples = prometheusSamples(metricsText(liveStatus(), busyReport(), 4096));
    const std::vector<std::pair<const char*, double>> expected{
        {"autostereo_uptime_seconds", 12.5},
        {"process_resident_memory_bytes", 4096},
        {"autostereo_shown{state=\"live\"}", 1},
        {"autostereo_shown{state=\"idle\"}", 0},
        {"autostereo_shown{state=\"pattern\"}", 0},
        {"autostereo_pictures_per_second", 29.5},
        {"autostereo_picture_age_seconds", 0.25},
        {"autostereo_stream_frames_total{stream=\"depth\"}", 110},
        {"autostereo_stream_frames_total{stream=\"color\"}", 120},
        {"autostereo_stream_unpaired_total{stream=\"color\"}", 20},
        {"autostereo_stream_damaged_total{stream=\"depth\"}", 2},
        {"autostereo_stream_reconnects_total{stream=\"color\"}", 5},
        {"autostereo_sensor_state{sensor=\"depth\",state=\"streaming\"}", 1},
        {"autostereo_sensor_state{sensor=\"depth\",state=\"lost\"}", 0},
        {"autostereo_sensor_state{sensor=\"color\",state=\"lost\"}", 1},
        {"autostereo_sensor_last_frame_seconds{sensor=\"depth\"}", 0.02},
        {"autostereo_pairs_total", 100},
        {"autostereo_frames_presented_total", 9007199254740992.0},
        {"autostereo_frames_dropped_total", 7},
        {"autostereo_frames_skipped_total{reason=\"stale\"}", 2},
        {"autostereo_frames_skipped_total{reason=\"unchanged\"}", 3},
        {"autostereo_frames_without_depth_total", 6},
        {"autostereo_recording_frames_total", 9},
        {"autostereo_recording_left_out_total", 1},
        {"autostereo_latency_seconds_bucket{le=\"0.005\"}", 2},
        {"autostereo_latency_seconds_bucket{le=\"0.01\"}", 3},
        {"autostereo_latency_seconds_bucket{le=\"0.05\"}", 4},
        {"autostereo_latency_seconds_bucket{le=\"1\"}", 4},
        {"autostereo_latency_seconds_bucket{le=\"+Inf\"}", 5},
        {"autostereo_latency_seconds_count", 5},
        {"autostereo_stage_median_seconds{stage=\"mesh\"}", 0.0025},
        {"autostereo_gpu_memory_bytes", 1.5 * 1024 * 1024},
        {"autostereo_gpu_objects", 12},
        {"autostereo_http_refused_total{status=\"401\"}", 3},
        {"autostereo_http_refused_total{status=\"503\"}", 1}};
    for (const auto& [name, value] : expected)
        EXPECT_TRUE(samples.contains(name) && samples.at(name) == value)
            << name << " is " << (samples.contains(name) ? samples.at(name) : -1);
    EXPECT_NEAR(samples.at("autostereo_latency_seconds_sum"), 5.0565, 1e-9);
    EXPECT_FALSE(samples.contains("autostereo_stage_median_seconds{stage=\"upload\"}"));
}

TEST(Metrics, WhatIsNotKnownIsLeftOut) {
    const auto samples = prometheusSamples(metricsText({}, {}, 0));
    for (const auto& [name, value] : samples)
        EXPECT_FALSE(name.find("sensor") != std::string::npos ||
                     name.find("recording") != std::string::npos ||
                     name.find("http") != std::string::npos ||
                     name.find("resident") != std::string::npos)
            << name;
    EXPECT_EQ(samples.at("autostereo_latency_seconds_count"), 0);
}

TEST(Metrics, MemoryIsWhatTheKernelSays) {
    const std::uint64_t before = residentMemory();
    const std::vector<char> more(64 << 20, 'x'); // touched, so resident
    EXPECT_GT(residentMemory(), before + (48 << 20)) << more.front();
}

TEST(PrometheusText, TheTestsReaderIsStrict) {
    const std::string good = "# HELP a_total x\n# TYPE a_total counter\na_total 1\n";
    EXPECT_EQ(prometheusSamples(good).at("a_total"), 1);
    for (const std::string& bad :
         {good + "a_total 2\n", good + good, std::string("a 1\n"), good + "b 1\n",
          std::string("# HELP a x\n# TYPE a counter\na 1\n"),
          std::string("# HELP a x\n# TYPE a gauge\na{b=\"c} 1\n"),
          std::string("# HELP a x\n# TYPE a gauge\na nan\n"), std::string("# TYPE a gauge\n"),
          std::string("# HELP a x\n# TYPE a gauge\na 1"),
          std::string("# HELP h x\n# TYPE h histogram\nh_bucket{le=\"1\"} 2\n"
                      "h_bucket{le=\"+Inf\"} 1\n"),
          std::string("# HELP h x\n# TYPE h histogram\nh_bucket{le=\"1\"} 2\nh_count 2\n")})
        EXPECT_THROW((void)prometheusSamples(bad), std::runtime_error) << bad;
}

} // namespace
} // namespace autostereo::daemon

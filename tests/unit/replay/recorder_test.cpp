// What is recorded is what was captured.

#include "devices/frame_pool.hpp"
#include "devices/record/recorder.hpp"
#include "devices/record/recording_source.hpp"
#include "devices/replay/kinect_recording.hpp"
#include "devices/replay/matroska_reader.hpp"
#include "devices/sim/simulation.hpp"
#include "tests/support/data.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/replay/playing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <tuple>

namespace autostereo {
namespace {

using devices::Recorder;
using WhenBehind = Recorder::WhenBehind;

/// Everything that an input's streams give, recorded on the way.
Recorder::Counters recordAll(devices::Input input, const std::filesystem::path& file) {
    auto recorder = std::make_shared<Recorder>(file, input, WhenBehind::Wait);
    const devices::Input tapped = devices::recorded(std::move(input), recorder);
    bool depth = tapped.depth != nullptr, color = tapped.color != nullptr;
    while (depth || color) {
        depth = depth && test::nextFrame(*tapped.depth).has_value();
        color = color && test::nextFrame(*tapped.color).has_value();
    }
    recorder->finish();
    return recorder->counters();
}

void expectSameDepth(devices::Source& a, devices::Source& b) {
    for (;;) {
        const auto first = test::nextFrame(a), second = test::nextFrame(b);
        ASSERT_EQ(first.has_value(), second.has_value());
        if (!first) return;
        EXPECT_TRUE(std::ranges::equal(first->depth(), second->depth()));
        EXPECT_TRUE(std::ranges::equal(first->amplitude(), second->amplitude()));
        EXPECT_EQ(first->metadata().depthUnitM, second->metadata().depthUnitM);
    }
}

void expectSameCamera(const calib::CameraModel& a, const calib::CameraModel& b) {
    const calib::Intrinsics &i = a.intrinsics, &j = b.intrinsics;
    EXPECT_EQ(std::tie(i.width, i.height, i.fx, i.fy, i.cx, i.cy),
              std::tie(j.width, j.height, j.fx, j.fy, j.cx, j.cy));
    const calib::Distortion &k = a.distortion, &l = b.distortion;
    EXPECT_EQ(std::tie(k.k1, k.k2, k.p1, k.p2, k.k3, k.k4, k.k5, k.k6, k.metricRadius),
              std::tie(l.k1, l.k2, l.p1, l.p2, l.k3, l.k4, l.k5, l.k6, l.metricRadius));
}

void expectSameRig(const calib::SensorRig& a, const calib::SensorRig& b) {
    expectSameCamera(a.depth, b.depth);
    expectSameCamera(a.color, b.color);
    EXPECT_EQ(a.colorFromDepth.rotation, b.colorFromDepth.rotation);
    EXPECT_EQ(a.colorFromDepth.translation, b.colorFromDepth.translation);
}

TEST(Recorder, ARealRecordingComesOutAsItWas) {
    AUTOSTEREO_NEED_DATA("k4a-mug/recording.mkv");
    const auto original = (test::dataDir() / "k4a-mug/recording.mkv").string();
    const test::ScratchFolder folder;
    const auto counters = recordAll(devices::openInput(original), folder / "again.mkv");
    EXPECT_EQ(counters.written, 2U);
    EXPECT_EQ(counters.leftOut, 0U);
    EXPECT_EQ(counters.bytes, std::filesystem::file_size(folder / "again.mkv"));

    const auto first = devices::openInput(original);
    const auto again = devices::openInput((folder / "again.mkv").string());
    expectSameDepth(*first.depth, *again.depth);
    const auto firstColor = test::nextFrame(*first.color), color = test::nextFrame(*again.color);
    ASSERT_TRUE(firstColor && color);
    EXPECT_TRUE(std::ranges::equal(firstColor->pixels(), color->pixels()));
    ASSERT_GT(firstColor->encoded().size(), 100'000U);
    EXPECT_TRUE(std::ranges::equal(firstColor->encoded(), color->encoded()));
    EXPECT_EQ(first.factoryCalibration, again.factoryCalibration);
    expectSameRig(*first.rig, *again.rig);
    EXPECT_EQ(first.nominalPeriod, again.nominalPeriod);
}

TEST(Recorder, ASimulationComesOutAsItWas) {
    const std::string uri = "sim:person?frames=12&depth=176x144&color=320x240";
    const test::ScratchFolder folder;
    EXPECT_EQ(recordAll(devices::sim::openSimulation(uri), folder / "sim.mkv").written, 24U);
    const auto first = devices::sim::openSimulation(uri);
    const auto again = devices::openInput((folder / "sim.mkv").string());
    expectSameDepth(*first.depth, *again.depth);
    expectSameRig(*first.rig, *again.rig);
    std::uint64_t pictures = 0;
    while (const auto color = test::nextFrame(*again.color)) {
        const auto truth = test::nextFrame(*first.color);
        ASSERT_TRUE(truth);
        ASSERT_EQ(color->metadata().format, devices::PixelFormat::Bgra8);
        for (std::size_t i = 0; i < truth->pixels().size(); i += 4) {
            ASSERT_EQ(truth->pixels()[i], color->pixels()[i + 2]);
            ASSERT_EQ(truth->pixels()[i + 1], color->pixels()[i + 1]);
            ASSERT_EQ(truth->pixels()[i + 2], color->pixels()[i]);
        }
        ++pictures;
    }
    EXPECT_EQ(pictures, 12U);
}

/// Pictures of one stream, made here.
class Pictures {
  public:
    devices::Frame next(devices::PixelFormat format, devices::TimePoint at, double unitM = 0.001) {
        devices::FrameMetadata form;
        form.format = format;
        form.width = 64;
        form.height = 48;
        form.capturedAt = at;
        form.depthUnitM = unitM;
        auto frame = pool_.acquire(form);
        for (std::byte& byte : frame->pixels())
            byte = static_cast<std::byte>(random_());
        return std::move(*frame);
    }

  private:
    devices::FramePool pool_{8};
    std::mt19937 random_{7};
};

devices::TimePoint at(int milliseconds) {
    return devices::TimePoint{std::chrono::milliseconds(milliseconds)};
}

/// An input that has these streams; nothing is read from it.
devices::Input inputOf(bool depth, bool color) {
    devices::Input input = devices::sim::openSimulation("sim:room?depth=64x48&color=64x48");
    if (!depth) input.depth.reset();
    if (!color) input.color.reset();
    return input;
}

TEST(Recorder, EveryFormatIsKeptOrTurnedIntoOneThatIs) {
    using devices::PixelFormat;
    for (const auto& [given, kept] : {std::pair{PixelFormat::Nv12, PixelFormat::Nv12},
                                      {PixelFormat::Yuyv, PixelFormat::Yuyv},
                                      {PixelFormat::Uyvy, PixelFormat::Yuyv},
                                      {PixelFormat::Bgra8, PixelFormat::Bgra8},
                                      {PixelFormat::Rgb8, PixelFormat::Bgra8},
                                      {PixelFormat::Bgr8, PixelFormat::Bgra8},
                                      {PixelFormat::Grey8, PixelFormat::Bgra8}}) {
        SCOPED_TRACE(static_cast<int>(given));
        const test::ScratchFolder folder;
        Pictures pictures;
        const devices::Frame frame = pictures.next(given, at(0));
        {
            Recorder recorder(folder / "f.mkv", inputOf(false, true), WhenBehind::Wait);
            recorder.offer(Recorder::Stream::Color, frame);
        }
        const auto input = devices::openInput((folder / "f.mkv").string());
        EXPECT_FALSE(input.depth);
        const auto again = test::nextFrame(*input.color);
        ASSERT_TRUE(again);
        EXPECT_EQ(again->metadata().format, kept);
        const auto from = frame.pixels(), to = again->pixels();
        if (given == kept && given != PixelFormat::Bgra8) {
            EXPECT_TRUE(std::ranges::equal(from, to));
        }
        // One pixel by hand: blue, green, red of the 100th; luma of a pair.
        if (given == PixelFormat::Rgb8) {
            EXPECT_EQ(to[400], from[302]);
            EXPECT_EQ(to[402], from[300]);
        }
        if (given == PixelFormat::Bgr8) {
            EXPECT_EQ(to[400], from[300]);
            EXPECT_EQ(to[402], from[302]);
        }
        if (given == PixelFormat::Grey8) {
            EXPECT_EQ(to[400], from[100]);
            EXPECT_EQ(to[402], from[100]);
        }
        if (given == PixelFormat::Uyvy) {
            EXPECT_EQ(to[200], from[201]);
            EXPECT_EQ(to[201], from[200]);
        }
    }
}

TEST(Recorder, PicturesAreInOrderOfTimeAndUnitsAreKept) {
    const test::ScratchFolder folder;
    Pictures pictures;
    {
        Recorder recorder(folder / "o.mkv", inputOf(true, true), WhenBehind::LeaveOut);
        for (const int time : {0, 30, 60, 90})
            recorder.offer(Recorder::Stream::Color,
                           pictures.next(devices::PixelFormat::Nv12, at(time)));
        for (const int time : {10, 40, 70})
            recorder.offer(Recorder::Stream::Depth,
                           pictures.next(devices::PixelFormat::Depth16, at(time), 0.0001));
    }
    const auto info = devices::readMatroskaInfo(folder / "o.mkv");
    devices::MatroskaBlocks color(folder / "o.mkv", info, 1), depth(folder / "o.mkv", info, 2);
    std::vector<std::int64_t> times;
    for (auto* blocks : {&color, &depth})
        while (const auto block = blocks->next())
            times.push_back(block->time.count() / 1'000'000);
    EXPECT_EQ(times, (std::vector<std::int64_t>{0, 30, 60, 90, 10, 40, 70}));
    const auto input = devices::openInput((folder / "o.mkv").string());
    EXPECT_EQ(test::nextFrame(*input.depth)->metadata().depthUnitM, 0.0001);

    // In the file as in time: positions of the clusters' time codes rise with the times.
    std::ifstream in(folder / "o.mkv", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    std::uint64_t last = 0;
    int clusters = 0;
    const std::string mark("\x1f\x43\xb6\x75", 4);
    for (auto place = bytes.find(mark); place != std::string::npos;
         place = bytes.find(mark, place + 1)) {
        std::uint64_t ticks = 0;
        for (std::size_t i = 0; i < 8; ++i)
            ticks = ticks << 8U | static_cast<unsigned char>(bytes[place + 12 + 9 + i]);
        EXPECT_GE(ticks, last);
        last = ticks;
        ++clusters;
    }
    EXPECT_EQ(clusters, 7);
    EXPECT_EQ(last, 90'000U); // microseconds
}

TEST(Recorder, WhatDoesNotFitIsLeftOutAndCounted) {
    const test::ScratchFolder folder;
    Pictures pictures;
    const devices::Frame frame = pictures.next(devices::PixelFormat::Grey8, at(0));
    // Colour that never comes keeps depth waiting; room for three pictures of 3 KiB.
    Recorder recorder(folder / "l.mkv", inputOf(true, true), WhenBehind::LeaveOut, 10'000);
    for (int i = 0; i < 10; ++i)
        recorder.offer(Recorder::Stream::Color, frame);
    recorder.finish();
    EXPECT_EQ(recorder.counters().written, 3U);
    EXPECT_EQ(recorder.counters().leftOut, 7U);
}

TEST(Recorder, ADiskThatRefusesIsSaid) {
    try {
        const Recorder recorder("/dev/full", inputOf(true, true), WhenBehind::LeaveOut);
        FAIL() << "recorded to a full disk";
    } catch (const devices::RecordingError& error) {
        EXPECT_STREQ(error.what(), "cannot record to /dev/full: No space left on device");
    }
}

} // namespace
} // namespace autostereo

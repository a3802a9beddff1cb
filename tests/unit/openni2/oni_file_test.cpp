#include "devices/openni2/oni_file.hpp"
#include "devices/sim/simulation.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <OniCAPI.h>

// Recordings made by OpenNI2's own recorder from the simulated camera, read back.

namespace autostereo::test {
namespace {

using namespace devices;

constexpr std::array kSensors{ONI_SENSOR_DEPTH, ONI_SENSOR_IR, ONI_SENSOR_COLOR};
constexpr int kFrames = 12;

/// At least `kFrames` each of depth, infrared and colour, however slow the machine; each stream
/// begins so much after the one before.
void record(const std::filesystem::path& file, std::chrono::milliseconds apart) {
    ASSERT_EQ(oniInitialize(ONI_API_VERSION), ONI_STATUS_OK);
    OniDeviceHandle device = nullptr;
    ASSERT_EQ(oniDeviceOpen("tofsim://room", &device), ONI_STATUS_OK);
    OniRecorderHandle recorder = nullptr;
    ASSERT_EQ(oniCreateRecorder(file.c_str(), &recorder), ONI_STATUS_OK);
    std::vector<OniStreamHandle> streams;
    for (const OniSensorType sensor : kSensors) {
        ASSERT_EQ(oniDeviceCreateStream(device, sensor, &streams.emplace_back()), ONI_STATUS_OK);
        ASSERT_EQ(oniRecorderAttachStream(recorder, streams.back(), FALSE), ONI_STATUS_OK);
    }
    ASSERT_EQ(oniRecorderStart(recorder), ONI_STATUS_OK);
    for (OniStreamHandle stream : streams) {
        ASSERT_EQ(oniStreamStart(stream), ONI_STATUS_OK);
        std::this_thread::sleep_for(apart);
    }
    for (int i = 0; i < kFrames; ++i)
        for (OniStreamHandle stream : streams) {
            int ready = 0;
            OniFrame* frame = nullptr;
            ASSERT_EQ(oniWaitForAnyStream(&stream, 1, &ready, 5000), ONI_STATUS_OK);
            ASSERT_EQ(oniStreamReadFrame(stream, &frame), ONI_STATUS_OK);
            oniFrameRelease(frame);
        }
    for (OniStreamHandle stream : streams)
        oniStreamStop(stream);
    oniRecorderStop(recorder);
    oniRecorderDestroy(&recorder);
    for (OniStreamHandle stream : streams)
        oniStreamDestroy(stream);
    oniDeviceClose(device);
    oniShutdown();
}

class OniFile : public testing::Test {
  protected:
    void SetUp() override {
        if (std::getenv("LD_LIBRARY_PATH") == nullptr)
            GTEST_SKIP() << "LD_LIBRARY_PATH does not lead to the simulated driver: run by ctest";
        ASSERT_NO_FATAL_FAILURE(record(file, apart()));
    }
    [[nodiscard]] virtual std::chrono::milliseconds apart() const { return {}; }
    void playsBackBitExact() const;
    ScratchFolder folder;
    std::filesystem::path file = folder / "room.oni";
};

/// Frames of a source that are the simulation's, in order; of a stream that may start late.
int matches(Source& played, Source& simulated,
            const std::function<bool(const Frame&, const Frame&)>& same) {
    int count = 0;
    bool started = false;
    auto result = played.read({});
    for (int i = 0; i < 200 && std::holds_alternative<Frame>(result); ++i) {
        const auto truth = simulated.read({});
        if (same(std::get<Frame>(result), std::get<Frame>(truth))) {
            started = true;
            ++count;
            result = played.read({});
        } else if (started) {
            ADD_FAILURE() << "frame " << count << " is another than recorded";
            return count;
        }
    }
    EXPECT_TRUE(std::holds_alternative<Ended>(result));
    return count;
}

void OniFile::playsBackBitExact() const {
    Input input = openInput(file.string());
    const Input truth = sim::openSimulation("sim:room?depth=160x144&color=320x180");
    ASSERT_TRUE(input.depth && input.color && input.rig);
    const int depth = matches(*input.depth, *truth.depth, [](const Frame& a, const Frame& b) {
        return std::ranges::equal(a.depth(), b.depth()) &&
               std::ranges::equal(a.amplitude(), b.amplitude());
    });
    const int color = matches(*input.color, *truth.color, [](const Frame& a, const Frame& b) {
        for (std::size_t p = 0; p < a.pixelCount(); ++p)
            if (!std::ranges::equal(a.pixels().subspan(3 * p, 3), b.pixels().subspan(4 * p, 3)))
                return false;
        return true;
    });
    EXPECT_GE(depth, 5);
    EXPECT_GE(color, 5);
    ASSERT_TRUE(input.depth->rewind());
    EXPECT_TRUE(std::holds_alternative<Frame>(input.depth->read({})));
}

TEST_F(OniFile, PlaysBackBitExact) { playsBackBitExact(); }

/// Each stream's pictures are numbered from its own first one.
class OniFileApart : public OniFile {
    [[nodiscard]] std::chrono::milliseconds apart() const override {
        return std::chrono::milliseconds(90);
    }
};
TEST_F(OniFileApart, PicturesTakenTogetherArePaired) { playsBackBitExact(); }

TEST_F(OniFile, DamagedFilesEndOrAreRefused) {
    const auto size = std::filesystem::file_size(file);
    std::filesystem::resize_file(file, size / 2); // its index is at the end
    try {
        Input input = openInput(file.string());
        if (input.depth)
            for (int i = 0; i < 100; ++i)
                if (std::holds_alternative<Ended>(input.depth->read({}))) return;
        FAIL() << "a cut file never ends";
    } catch (const DeviceError& error) {
        EXPECT_NE(std::string(error.what()).find("damaged"), std::string::npos) << error.what();
    }
}

TEST_F(OniFile, WhatIsNoneIsSaidInOneLine) {
    std::ofstream(file) << "nothing";
    ::testing::internal::CaptureStderr();
    try {
        static_cast<void>(openInput(file.string()));
        ADD_FAILURE() << "opened";
    } catch (const DeviceError& error) {
        const std::string what = error.what();
        EXPECT_EQ(what.find(file.string() + ": no "), 0U) << what;
        EXPECT_NE(what.find("no OpenNI2 recording: openni2: cannot open "), std::string::npos)
            << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

} // namespace
} // namespace autostereo::test

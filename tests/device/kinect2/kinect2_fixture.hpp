#pragma once

#include "devices/input.hpp"
#include "devices/kinect2/phase_decoder.hpp"
#include "tests/device/tof/stairs_show.hpp"
#include "tests/device/usbip/plug.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace autostereo::test {

/// What the source has to make of each exposure and JPEG, in the program's own frames: columns the
/// right way round, counts of depth, amplitudes, RGBA.
struct ExpectedPictures {
    std::vector<std::vector<std::uint16_t>> depth;
    std::vector<std::vector<std::uint16_t>> infrared;
    std::vector<std::vector<std::byte>> jpegs; ///< as they were sent
    std::vector<std::vector<std::byte>> color;

    /// Which exposure a frame is: depth to one count, amplitudes and JPEGs bit for bit, of decoded
    /// colour every 13th row. Nothing: none.
    [[nodiscard]] std::optional<std::size_t> find(const devices::Frame& frame) const;
};
[[nodiscard]] const ExpectedPictures& expectedPictures();

/// Full rate where this machine can decode twice as fast with one processor, else a half of it,
/// and so on.
[[nodiscard]] double possibleFps();

/// Stops a thread of this process, by its name, for a while; false: there is none.
[[nodiscard]] bool holdThread(const std::string& name, std::chrono::milliseconds time);

/// A camera that can be plugged in.
class Kinect2Test : public testing::Test {
  protected:
    static void SetUpTestSuite();
    void SetUp() override {
        if (!usbip::Plug::possible()) GTEST_SKIP() << "no virtual USB ports: run in the guest";
    }
    void TearDown() override { plug.reset(); }

    /// Waits until the kernel has it.
    void plugIn(double fps = possibleFps());
    void plugInAgain();
    void setFaults(const usbip::Faults& depth, const usbip::Faults& color);

    std::optional<Kinect2Camera> camera;
    std::unique_ptr<usbip::Plug> plug;
};

/// The next frame of a source within `patience`; empty: none, `why` may say the reason.
[[nodiscard]] devices::Frame
nextFrame(devices::Source& source, std::string* why = nullptr,
          std::chrono::milliseconds patience = std::chrono::seconds(3));

} // namespace autostereo::test

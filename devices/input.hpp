#pragma once

#include "calib/sensor_rig.hpp"
#include "devices/record/raw_recording.hpp"
#include "devices/source.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace autostereo::devices {

/// Thrown while opening: what was tried, on what, why, what to do; one line.
/// `notFound` tells exit code 3 (device or file not there) from 1 (there but unreadable).
class DeviceError : public std::runtime_error {
  public:
    explicit DeviceError(const std::string& what, bool notFound = false)
        : std::runtime_error(what), notFound_(notFound) {}
    [[nodiscard]] bool notFound() const noexcept { return notFound_; }

  private:
    bool notFound_;
};

/// An input address with words in it that mean nothing, or not yet: the command line is at fault.
class AddressError : public DeviceError {
  public:
    explicit AddressError(const std::string& what) : DeviceError(what) {}
};

/// How to open the two sensors again.
struct Reopeners {
    Reopen depth;
    Reopen color;
};

/// An opened input URI: one source per stream, either may be absent (colour alone, depth alone).
struct Input {
    std::string uri;
    std::string description; ///< for people: "Azure Kinect recording, 640x576 depth, ..."
    std::unique_ptr<Source> depth;
    std::unique_ptr<Source> color;
    /// The input's own calibration, if it has one; a missing camera of a single-stream input is
    /// filled in by `completeStreams`.
    std::optional<calib::SensorRig> rig;
    /// calibration.json of an Azure Kinect, as its maker wrote it; empty: none.
    std::vector<std::byte> factoryCalibration{};
    Duration startsAt{0};      ///< media time of the first frame of either stream
    Duration nominalPeriod{0}; ///< between frames, 0: unknown
    Reopeners reopen;
    /// Starts to write what the device sends below its decoder; throws RecordingError. Empty: this
    /// input has nothing there.
    std::function<std::shared_ptr<RawRecording>(const std::filesystem::path&)> recordRaw;
    bool depthIsLive = false; ///< stamped by a sensor, on the host's clock; else a recording
    bool colorIsLive = false;
    std::vector<std::string> warnings;
};

/// Opens any input URI of the command line; `rig` (from --rig) replaces the input's own numbers
/// (and is needed by `seq:` folders that have no camera.json). Throws DeviceError.
[[nodiscard]] Input openInput(const std::string& uri,
                              const std::optional<calib::SensorRig>& rig = std::nullopt);

} // namespace autostereo::devices

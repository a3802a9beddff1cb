#pragma once

#include "devices/frame.hpp"
#include "devices/openni2/openni_session.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace autostereo::devices::openni2 {

enum class Sensor : std::uint8_t { Depth, Infrared, Color };

/// How a stream was set up, as the device reports it back.
struct StreamShape {
    Sensor sensor = Sensor::Depth;
    PixelFormat format = PixelFormat::Depth16; ///< infrared: Depth16 with the counts as they are
    int width = 0;
    int height = 0;
    int fps = 0;
    double depthUnitM = 0.001;
    double horizontalFov = 0; ///< radians, 0: not said
    double verticalFov = 0;
    int frames = 0; ///< in a recording
};

struct DeviceRequest {
    std::string uri; ///< empty: the first one found
    std::vector<Sensor> sensors;
    bool fineDepth = false;  ///< steps of 0.1 mm (up to 6.5 m) instead of 1 mm
    bool registered = false; ///< depth as the colour camera sees it, by the device
    bool recording = false;  ///< `uri` is an .oni file, of which every frame is wanted once
};

/// Pixels that the library lends until destruction.
class Picture {
  public:
    struct Handle;
    explicit Picture(std::unique_ptr<Handle> handle, Sensor sensor);
    Picture(Picture&&) noexcept;
    Picture& operator=(Picture&&) noexcept;
    ~Picture();

    [[nodiscard]] Sensor sensor() const { return sensor_; }
    [[nodiscard]] int index() const;          ///< equal for pictures taken together
    [[nodiscard]] Duration timestamp() const; ///< the driver's own clock
    /// Copies its rows, tightly packed, if it has exactly that shape; else false.
    [[nodiscard]] bool copyTo(const StreamShape& shape, std::span<std::byte> pixels) const;

  private:
    std::unique_ptr<Handle> handle_;
    Sensor sensor_;
};

/// Open streams of one OpenNI2 device, running. A device may be open several times in one process.
/// Streams are stopped and destroyed before the device is closed, without which the library
/// crashes. Thread-bound.
class Device {
  public:
    /// Throws DeviceError. Infrared that cannot run beside depth is left out.
    explicit Device(const DeviceRequest& request);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] const std::vector<StreamShape>& streams() const { return shapes_; }
    [[nodiscard]] const StreamShape* stream(Sensor sensor) const;
    [[nodiscard]] const std::string& uri() const { return uri_; }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] bool recording() const { return recording_; }
    [[nodiscard]] bool registered() const { return registered_; }
    [[nodiscard]] bool has(Sensor sensor) const;

    /// The next picture of any stream, the oldest first; nothing when none came in time.
    [[nodiscard]] std::optional<Picture> next(Duration wait);
    /// Unplugged, or in error.
    [[nodiscard]] bool lost() const;

  private:
    struct Handles;
    void openDevice(const DeviceRequest& request);
    void addStream(Sensor sensor, const DeviceRequest& request);
    void startStreams();
    void playOnceByHand();

    std::shared_ptr<Session> session_;
    std::unique_ptr<Handles> handles_;
    std::vector<StreamShape> shapes_;
    std::string uri_;
    std::string name_;
    bool registered_ = false;
    bool recording_ = false;
};

} // namespace autostereo::devices::openni2

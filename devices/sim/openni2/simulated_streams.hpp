#pragma once

#include "devices/frame_pool.hpp"
#include "devices/sim/depth_camera.hpp"
#include "devices/sim/simulation.hpp"

#include <array>
#include <atomic>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include <Driver/OniDriverAPI.h>

namespace autostereo::devices::sim {

class SimulatedDevice;

/// One of the streams; frames are made by the device's thread.
class SimulatedStream final : public oni::driver::StreamBase {
  public:
    SimulatedStream(SimulatedDevice& device, OniSensorType sensor);
    ~SimulatedStream() override;

    OniStatus start() override;
    void stop() override;
    OniBool isPropertySupported(int property) override;
    OniStatus getProperty(int property, void* data, int* size) override;
    OniStatus setProperty(int property, const void* data, int size) override;

    [[nodiscard]] OniSensorType sensor() const { return sensor_; }
    /// Of the device's thread, under its lock: hands one picture out if the stream runs.
    void show(const Frame& frame, int index, std::uint64_t microseconds);

  private:
    void fill(const Frame& frame, OniFrame& picture) const;

    SimulatedDevice& device_;
    OniSensorType sensor_;
    OniVideoMode mode_;
    bool running_ = false;
};

class SimulatedDevice final : public oni::driver::DeviceBase {
  public:
    static constexpr int kDepthWidth = 160, kDepthHeight = 144;
    static constexpr int kColorWidth = 320, kColorHeight = 180;
    static constexpr int kFps = 30;

    SimulatedDevice();
    ~SimulatedDevice() override;

    OniStatus getSensorInfoList(OniSensorInfo** infos, int* count) override;
    oni::driver::StreamBase* createStream(OniSensorType sensor) override;
    void destroyStream(oni::driver::StreamBase* stream) override;
    OniBool isPropertySupported(int property) override;
    OniStatus getProperty(int property, void* data, int* size) override;
    OniStatus setProperty(int property, const void* data, int size) override;
    OniBool isImageRegistrationModeSupported(OniImageRegistrationMode) override { return TRUE; }

    /// As if the cable were pulled: open streams stay, no frame comes any more.
    void forget(const SimulatedStream& stream);
    void fallSilent();
    [[nodiscard]] const calib::SensorRig& rig() const { return rig_; }
    [[nodiscard]] std::mutex& mutex() { return mutex_; }
    [[nodiscard]] const OniSensorInfo& info(OniSensorType sensor) const;

  private:
    void run(const std::stop_token& stop);
    void showAll(int index);

    calib::SensorRig rig_;
    std::shared_ptr<const Scene> scene_;
    Input cameras_;
    DepthCamera registeredCamera_;
    FramePool registeredFrames_{2};
    std::array<std::vector<OniVideoMode>, 3> modes_;
    std::array<OniSensorInfo, 3> infos_{};
    OniImageRegistrationMode registration_ = ONI_IMAGE_REGISTRATION_OFF;
    std::mutex mutex_; ///< guards streams_ and their states
    std::vector<SimulatedStream*> streams_;
    bool silent_ = false;
    std::jthread thread_; // last: it uses all of the above
};

} // namespace autostereo::devices::sim

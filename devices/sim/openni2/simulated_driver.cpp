// The simulated cameras as an OpenNI2 driver plug-in, so that programs that know OpenNI2 can be run
// and tested without a camera: device tofsim://room with depth (1 mm or 0.1 mm), infrared and
// colour, frame k of `sim:room` as frame k + 1 of each stream. Registered depth is what a depth
// camera in the colour camera's place would see.

#include "devices/sim/openni2/simulated_streams.hpp"

#include <cstring>
#include <memory>
#include <mutex>

// Two macros that Debian's package does not ship.
#define XN_NEW(T, argument) new T(argument)
#define XN_DELETE(pointer) delete pointer

namespace autostereo::devices::sim {
namespace {

class Driver final : public oni::driver::DriverBase {
  public:
    explicit Driver(OniDriverServices* services) : DriverBase(services) {
        std::strncpy(info_.uri, "tofsim://room", sizeof info_.uri - 1);
        std::strncpy(info_.vendor, "autostereo", sizeof info_.vendor - 1);
        std::strncpy(info_.name, "simulated ToF camera", sizeof info_.name - 1);
        current = this;
    }
    ~Driver() override { current = nullptr; }

    OniStatus initialize(oni::driver::DeviceConnectedCallback connected,
                         oni::driver::DeviceDisconnectedCallback disconnected,
                         oni::driver::DeviceStateChangedCallback stateChanged,
                         void* cookie) override {
        DriverBase::initialize(connected, disconnected, stateChanged, cookie);
        plug();
        return ONI_STATUS_OK;
    }
    oni::driver::DeviceBase* deviceOpen(const char* uri, const char*) override {
        const std::lock_guard lock(mutex_);
        if (!plugged_ || std::strcmp(uri, info_.uri) != 0) return nullptr;
        device_ = new SimulatedDevice; // the library gives it back to deviceClose
        return device_;
    }
    void deviceClose(oni::driver::DeviceBase* device) override {
        const std::lock_guard lock(mutex_);
        if (device == device_) device_ = nullptr;
        delete static_cast<SimulatedDevice*>(device);
    }
    void shutdown() override {}

    void plug() {
        {
            const std::lock_guard lock(mutex_);
            if (plugged_) return;
            plugged_ = true;
        }
        deviceConnected(&info_);
        deviceStateChanged(&info_, ONI_DEVICE_STATE_OK);
    }
    void unplug() {
        {
            const std::lock_guard lock(mutex_);
            if (!plugged_) return;
            plugged_ = false;
            if (device_ != nullptr) device_->fallSilent();
        }
        deviceStateChanged(&info_, ONI_DEVICE_STATE_ERROR);
        deviceDisconnected(&info_);
    }

    static Driver* current; // the library makes one

  private:
    OniDeviceInfo info_{};
    std::mutex mutex_;
    SimulatedDevice* device_ = nullptr;
    bool plugged_ = false;
};

Driver* Driver::current = nullptr;

} // namespace
} // namespace autostereo::devices::sim

ONI_EXPORT_DRIVER(autostereo::devices::sim::Driver)

// For tests in the same process.
extern "C" __attribute__((visibility("default"))) void autostereoSimulatedUnplug() {
    if (auto* driver = autostereo::devices::sim::Driver::current) driver->unplug();
}
extern "C" __attribute__((visibility("default"))) void autostereoSimulatedPlug() {
    if (auto* driver = autostereo::devices::sim::Driver::current) driver->plug();
}

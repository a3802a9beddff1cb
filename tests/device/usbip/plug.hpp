#pragma once

#include "tests/device/usbip/faults.hpp"
#include "tests/device/usbip/pipe.hpp"
#include "tests/device/usbip/wire.hpp"

#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace autostereo::test::usbip {

enum class Speed : std::uint8_t { High = 3, Super = 5 }; ///< the kernel's numbers

/// Plugs a device into a virtual USB port of this machine's kernel (USB/IP's vhci_hcd; root is
/// needed) and is that device's thread. Destruction pulls the plug. The kernel enumerates
/// the device in the background: wait for its node to appear. Thread-safe.
class Plug {
  public:
    /// `device` must outlive the plug. Throws std::runtime_error where there is no virtual port.
    Plug(Device& device, Speed speed);
    ~Plug();
    Plug(const Plug&) = delete;
    Plug& operator=(const Plug&) = delete;

    /// Whether this kernel has virtual ports at all.
    [[nodiscard]] static bool possible();

    /// From the next packet on. `endpoint` with the direction's bit.
    void setFaults(std::uint8_t endpoint, const Faults& faults);
    /// Pulls the plug: every transfer ends with ENODEV. Returns when the port is free again, after
    /// two seconds at the latest.
    void pull();
    /// False after `pull`, a fault that unplugs, or when the kernel dropped the device.
    [[nodiscard]] bool plugged() const { return plugged_.load(); }

  private:
    void run(const std::stop_token& stop);
    [[nodiscard]] bool serve();
    [[nodiscard]] bool hostSpeaks(std::chrono::nanoseconds patience) const;
    [[nodiscard]] bool receive();
    [[nodiscard]] bool handle(Submit submit);
    [[nodiscard]] bool handle(Unlink unlink);
    [[nodiscard]] bool control(const Submit& submit);
    [[nodiscard]] std::optional<Bytes> standardAnswer(const Setup& setup);
    void takeFaults();

    Device& device_;
    Descriptors descriptors_;
    std::map<std::uint8_t, Endpoint> endpoints_;
    std::map<std::uint8_t, Pipe> pipes_;
    int port_ = -1;
    std::optional<Wire> wire_;
    std::mutex mutex_;
    std::map<std::uint8_t, Faults> newFaults_; ///< under mutex_
    std::atomic<bool> plugged_{false};
    std::jthread thread_; // last: it uses all of the above
};

} // namespace autostereo::test::usbip

#pragma once

#include "devices/kinect2/command.hpp"
#include "devices/kinect2/unit_facts.hpp"
#include "devices/kinect2/usb/usb_link.hpp"

#include <initializer_list>
#include <vector>

namespace autostereo::devices::kinect2 {

/// Starts and stops a camera: commands and their replies over an open link, in the order in which
/// the maker's driver sends them. Everything throws DeviceError. Thread-bound.
class UnitControl {
  public:
    explicit UnitControl(UsbLink& link);

    /// Reads its pages and starts both streams; a camera that still wakes up is waited for, five
    /// seconds at most. Transfers may then be sent.
    [[nodiscard]] UnitFacts start();
    /// When no transfer is on its way any more.
    void stop();

  private:
    [[nodiscard]] std::vector<std::byte> ask(Command command, std::uint32_t replyBytes,
                                             std::initializer_list<std::uint32_t> parameters);
    void tell(Command command, std::initializer_list<std::uint32_t> parameters);
    [[nodiscard]] std::vector<std::byte> page(Page which, std::uint32_t most = kPageBytes);
    void forgetOldReplies();
    void waitUntilReady();
    void pulseMode();
    void suspendFunction(bool suspended);

    UsbLink& link_;
    std::uint32_t lastId_;
};

} // namespace autostereo::devices::kinect2

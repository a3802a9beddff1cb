#pragma once

#include "tests/device/usbip/bytes.hpp"

#include <cstdint>
#include <map>
#include <string>

namespace autostereo::test::usbip {

/// What a device says about itself, as bytes, so that a test can also make it lie.
struct Descriptors {
    Bytes device;
    Bytes configuration; ///< with everything that belongs to it, as `finishConfiguration` left it
    Bytes capabilities;  ///< binary object store; empty: none (high speed)
    std::map<std::uint8_t, std::string> strings; ///< by index, ASCII
};

/// Values of bmAttributes.
enum class EndpointType : std::uint8_t { Control, Isochronous, Bulk, Interrupt };

struct Endpoint {
    std::uint8_t address = 0; ///< with the direction's bit: 0x80 is IN
    EndpointType type = EndpointType::Bulk;
    std::uint8_t interval = 1; ///< bInterval: 2^(n-1) microframes of 125 us
};

/// All endpoints of all alternate settings, by address. Bytes that make no sense end the search.
[[nodiscard]] std::map<std::uint8_t, Endpoint> endpointsOf(const Bytes& configuration);

/// Pieces of a configuration. `interface` is bInterfaceNumber; kind = {class, subclass, protocol}.
struct InterfaceKind {
    std::uint8_t code = 0xff;
    std::uint8_t subclass = 0;
    std::uint8_t protocol = 0;
};
[[nodiscard]] Bytes configurationHeader(unsigned interfaces);
[[nodiscard]] Bytes interfaceDescriptor(unsigned number, unsigned alternate, unsigned endpoints,
                                        InterfaceKind kind);
[[nodiscard]] Bytes endpointDescriptor(const Endpoint& endpoint, unsigned mostPacketBytes);
/// SuperSpeed's addition to an endpoint. `burst` packets at once, counted from 0; for isochronous
/// endpoints `mult` bursts an interval, counted from 0, and `intervalBytes` in all.
[[nodiscard]] Bytes companionDescriptor(unsigned burst, unsigned mult, unsigned intervalBytes);
/// Writes wTotalLength, when everything is in.
void finishConfiguration(Bytes& configuration);
/// Capabilities that a SuperSpeed device has to have.
[[nodiscard]] Bytes superSpeedCapabilities();
/// A string descriptor; index 0 is the list of languages.
[[nodiscard]] Bytes stringDescriptor(const Descriptors& all, std::uint8_t index);

} // namespace autostereo::test::usbip

#include "tests/device/usbip/descriptors.hpp"

#include <cstddef>

namespace autostereo::test::usbip {

std::map<std::uint8_t, Endpoint> endpointsOf(const Bytes& configuration) {
    constexpr std::uint8_t kEndpoint = 5, kTypeMask = 3;
    std::map<std::uint8_t, Endpoint> endpoints;
    std::size_t length = 0;
    for (std::size_t at = 0; at + 2 <= configuration.size(); at += length) {
        length = configuration[at];
        if (length < 2 || at + length > configuration.size()) break;
        if (configuration[at + 1] != kEndpoint || length < 7) continue;
        const auto type = static_cast<EndpointType>(configuration[at + 3] & kTypeMask);
        endpoints[configuration[at + 2]] = {configuration[at + 2], type, configuration[at + 6]};
    }
    return endpoints;
}

Bytes configurationHeader(unsigned interfaces) {
    constexpr unsigned kBusPowered = 0x80, kMostPower = 50; // 100 mA, SuperSpeed: 400 mA
    return {9, 2, 0, 0, static_cast<std::uint8_t>(interfaces), 1, 0, kBusPowered, kMostPower};
}

Bytes interfaceDescriptor(unsigned number, unsigned alternate, unsigned endpoints,
                          InterfaceKind kind) {
    Bytes bytes;
    put(bytes, {9, 4, number, alternate, endpoints, kind.code, kind.subclass, kind.protocol, 0});
    return bytes;
}

Bytes endpointDescriptor(const Endpoint& endpoint, unsigned mostPacketBytes) {
    Bytes bytes;
    put(bytes, {7, 5, endpoint.address, static_cast<unsigned>(endpoint.type)});
    put16(bytes, mostPacketBytes);
    put8(bytes, endpoint.interval);
    return bytes;
}

Bytes companionDescriptor(unsigned burst, unsigned mult, unsigned intervalBytes) {
    Bytes bytes;
    put(bytes, {6, 0x30, burst, mult});
    put16(bytes, intervalBytes);
    return bytes;
}

void finishConfiguration(Bytes& configuration) {
    configuration[2] = static_cast<std::uint8_t>(configuration.size() & 0xffU);
    configuration[3] = static_cast<std::uint8_t>(configuration.size() >> 8U);
}

Bytes superSpeedCapabilities() {
    return {5,  15, 22, 0, 2,                 // the store: 22 bytes, two capabilities
            7,  16, 2,  2, 0, 0, 0,           // USB 2.0 extension: link power management
            10, 16, 3,  0, 8, 0, 3, 0, 0, 0}; // SuperSpeed: 5 Gb/s, from high speed on
}

Bytes stringDescriptor(const Descriptors& all, std::uint8_t index) {
    constexpr unsigned kString = 3, kLongest = 126;
    if (index == 0) return {4, kString, 0x09, 0x04}; // English
    const auto found = all.strings.find(index);
    if (found == all.strings.end()) return {};
    const std::string text = found->second.substr(0, kLongest);
    Bytes bytes{static_cast<std::uint8_t>(2 + 2 * text.size()), kString};
    for (const char letter : text)
        put16(bytes, static_cast<unsigned char>(letter));
    return bytes;
}

} // namespace autostereo::test::usbip

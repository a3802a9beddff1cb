#include "tests/device/uvc/uvc_descriptors.hpp"

namespace autostereo::test {

namespace {

using usbip::Bytes;
using usbip::put, usbip::put8, usbip::put16, usbip::put32;

constexpr unsigned kClassInterface = 0x24;
constexpr unsigned kHundredNsPerSecond = 10'000'000;
constexpr usbip::InterfaceKind kVideoControl{0x0e, 1, 0}, kVideoStreaming{0x0e, 2, 0};

void writeLength16(Bytes& bytes, std::size_t at) {
    bytes[at] = static_cast<std::uint8_t>(bytes.size() & 0xffU);
    bytes[at + 1] = static_cast<std::uint8_t>(bytes.size() >> 8U);
}

/// A camera (entity 1), its processing (2) and a way out (3).
Bytes controlPart() {
    constexpr unsigned kClockHz = 48'000'000, kOutput = 3;
    // Bits of what can be set: exposure mode, priority and time; brightness, white balance
    // temperature, gain, power line frequency, automatic white balance.
    constexpr unsigned kTerminalBits = 0x0e, kProcessingBits = 0x1641;
    Bytes bytes;
    put(bytes, {13, kClassInterface, 1, 0x10, 0x01, 0, 0});
    put32(bytes, kClockHz);
    put(bytes, {1, 1});
    put(bytes, {18, kClassInterface, 2, kUvcTerminal, 0x01, 0x02, 0, 0, 0, 0, 0, 0, 0, 0, 3,
                kTerminalBits, 0, 0});
    put(bytes, {12, kClassInterface, 5, kUvcProcessing, kUvcTerminal, 0, 0, 2});
    put16(bytes, kProcessingBits);
    put(bytes, {0, 0});
    put(bytes, {9, kClassInterface, 3, kOutput, 0x01, 0x01, 0, kUvcProcessing, 0});
    writeLength16(bytes, 5);
    return bytes;
}

/// The format and, in the same subtype plus one, its only frame size.
Bytes formatPart(const UvcFormat& format, unsigned index, const UvcParams& params) {
    constexpr unsigned kYuyvFormat = 4, kMjpegFormat = 6;
    Bytes bytes;
    if (format.kind == UvcFormat::Kind::Mjpeg) {
        put(bytes, {11, kClassInterface, kMjpegFormat, index, 1, 1, 1, 0, 0, 0, 0});
    } else {
        put(bytes, {27, kClassInterface, kYuyvFormat, index, 1});
        put(bytes, {'Y', 'U', 'Y', '2', 0, 0, 0x10, 0, 0x80, 0, 0, 0xaa, 0, 0x38, 0x9b, 0x71});
        put(bytes, {16, 1, 0, 0, 0, 0});
    }
    const auto rates = static_cast<unsigned>(params.framesPerSecond.size());
    const auto pixels = static_cast<std::uint32_t>(format.width * format.height);
    put(bytes, {26 + 4 * rates, kClassInterface,
                (format.kind == UvcFormat::Kind::Mjpeg ? kMjpegFormat : kYuyvFormat) + 1, 1, 0});
    put16(bytes, static_cast<unsigned>(format.width));
    put16(bytes, static_cast<unsigned>(format.height));
    put32(bytes, pixels * 16);
    put32(bytes, pixels * 16 * params.framesPerSecond.front());
    put32(bytes, pixels * 2);
    put32(bytes, kHundredNsPerSecond / params.framesPerSecond.front());
    put(bytes, {rates});
    for (const unsigned rate : params.framesPerSecond)
        put32(bytes, kHundredNsPerSecond / rate);
    put(bytes, {6, kClassInterface, 13, 1, 1, 4}); // colours: BT.709 primaries, BT.601 matrix
    return bytes;
}

Bytes streamingPart(const UvcParams& params) {
    const auto formats = static_cast<unsigned>(params.formats.size());
    Bytes bytes;
    put(bytes,
        {13 + formats, kClassInterface, 1, formats, 0, 0, UvcCamera::kVideo, 0, 3, 0, 0, 0, 1});
    for (unsigned i = 0; i < formats; ++i)
        put8(bytes, 0);
    for (unsigned i = 0; i < formats; ++i)
        put(bytes, formatPart(params.formats[i], i + 1, params));
    writeLength16(bytes, 4);
    return bytes;
}

Bytes configuration(const UvcParams& params) {
    constexpr unsigned kThreePackets = 2U << 11U;
    Bytes bytes = usbip::configurationHeader(2);
    put(bytes, {8, 11, 0, 2, 0x0e, 3, 0, 0}); // both interfaces are one function
    put(bytes, usbip::interfaceDescriptor(0, 0, 0, kVideoControl));
    put(bytes, controlPart());
    const bool isochronous = params.isochronous;
    put(bytes, usbip::interfaceDescriptor(1, 0, isochronous ? 0 : 1, kVideoStreaming));
    put(bytes, streamingPart(params));
    if (isochronous) {
        put(bytes, usbip::interfaceDescriptor(1, 1, 1, kVideoStreaming));
        put(bytes,
            usbip::endpointDescriptor({UvcCamera::kVideo, usbip::EndpointType::Isochronous, 1},
                                      kUvcIntervalBytes / 3 | kThreePackets));
    } else {
        put(bytes,
            usbip::endpointDescriptor({UvcCamera::kVideo, usbip::EndpointType::Bulk, 0}, 512));
    }
    usbip::finishConfiguration(bytes);
    return bytes;
}

} // namespace

usbip::Descriptors uvcDescriptors(const UvcParams& params) {
    usbip::Descriptors all;
    // 1209: a vendor number for open source projects.
    all.device = {18, 1, 0, 2, 0xef, 2, 1, 64, 0x09, 0x12, 2, 0, 0, 1, 1, 2, 3, 1};
    all.configuration = configuration(params);
    all.strings = {{1, "autostereo"}, {2, params.product}, {3, params.serial}};
    return all;
}

} // namespace autostereo::test

#include "calib/depth_frame_header.hpp"

namespace autostereo::calib {

std::uint32_t depthFrameCrc(std::span<const std::uint8_t> bytes) {
    constexpr std::uint32_t kPolynomial = 0x04C11DB7;
    constexpr std::uint32_t kTop = 0x80000000;
    std::uint32_t remainder = 0;
    for (const std::uint8_t byte : bytes) {
        remainder ^= std::uint32_t{byte} << 24;
        for (int bit = 0; bit < 8; ++bit)
            remainder = (remainder << 1) ^ ((remainder & kTop) != 0 ? kPolynomial : 0);
    }
    return remainder;
}

std::array<std::uint8_t, 10> depthFrameHeader(const DepthFrame& frame) {
    std::array<std::uint8_t, 10> header{0xF1, static_cast<std::uint8_t>(frame.contentType),
                                        static_cast<std::uint8_t>(frame.factor),
                                        static_cast<std::uint8_t>(frame.offset)};
    constexpr std::size_t kCovered = 6;
    const std::uint32_t crc = depthFrameCrc(std::span(header).first(kCovered));
    for (std::size_t byte = 0; byte < 4; ++byte)
        header.at(kCovered + byte) = static_cast<std::uint8_t>(crc >> (24 - 8 * byte));
    return header;
}

std::vector<std::uint8_t> depthFrameHeaderRow(const DepthFrame& frame) {
    constexpr std::size_t kOverwritten = 256;
    std::vector<std::uint8_t> row(kOverwritten, 0);
    std::size_t x = 0;
    for (const std::uint8_t byte : depthFrameHeader(frame))
        for (int bit = 7; bit >= 0; --bit, x += 2)
            row[x] = (byte >> bit & 1) != 0 ? 255 : 0;
    return row;
}

} // namespace autostereo::calib

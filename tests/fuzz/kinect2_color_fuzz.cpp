#include "devices/kinect2/color_packets.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <cstring>

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own entry

namespace {

using namespace devices::kinect2;

void requireInside(std::span<const std::byte> jpeg, std::size_t size) {
    fuzz::require(jpeg.size() < size, "a picture as big as its packet");
    unsigned sum = 0; // reads every byte: the sanitizer sees what is outside
    for (const std::byte byte : jpeg)
        sum += std::to_integer<unsigned>(byte);
    fuzz::require(sum <= 255 * jpeg.size(), "a sum");
}

/// Marks and sizes that agree, which no mutation would find.
std::vector<std::byte> repaired(std::span<const std::byte> bytes) {
    std::vector<std::byte> copy(bytes.begin(), bytes.end());
    if (copy.size() < 64) return copy;
    const auto put = [&](std::size_t at, std::uint32_t value) {
        std::memcpy(copy.data() + at, &value, sizeof value);
    };
    const std::size_t footer = copy.size() - 56;
    put(4, 0x42424242);
    put(footer, 0x39393939);
    std::memcpy(copy.data() + footer + 4, copy.data(), 4);
    put(footer + 32, 0x42424242);
    put(footer + 36, static_cast<std::uint32_t>(copy.size()));
    return copy;
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = fuzz::bytesOf(data, size);
    ColorPackets packets;
    const auto good = repaired(bytes);
    if (const auto packet = parseColorPacket(good)) requireInside(packet->jpeg, good.size());
    for (std::size_t at = 0; at < size;) {
        const std::size_t part = std::min<std::size_t>(1 + data[at], size - at);
        if (const auto packet = packets.append(bytes.subspan(at, part)))
            requireInside(packet->jpeg, size);
        at += part;
    }
    static_cast<void>(packets.append(good));
    return 0;
}

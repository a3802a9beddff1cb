#include "devices/kinect2/color_packets.hpp"

#include "devices/kinect2/little_endian.hpp"

#include <algorithm>

namespace autostereo::devices::kinect2 {

namespace {

constexpr std::uint32_t kBegin = 0x42424242; // BBBB
constexpr std::uint32_t kEnd = 0x39393939;   // 9999

struct Header {
    std::uint32_t sequence;
    std::uint32_t magic;
};

struct ColorFooter {
    std::uint32_t magic;
    std::uint32_t sequence;
    std::uint32_t fillerBytes;
    std::uint32_t unknown[2];
    std::uint32_t timestamp;
    float exposureMs;
    float digitalGain;
    std::uint32_t headerMagic;
    std::uint32_t packetBytes;
    float analogGain;
    std::uint32_t unused[3];
};
static_assert(sizeof(ColorFooter) == 56);

bool endsWithFooter(std::span<const std::byte> bytes) {
    if (bytes.size() < sizeof(Header) + sizeof(ColorFooter)) return false;
    const auto footer = valueAt<ColorFooter>(bytes, bytes.size() - sizeof(ColorFooter));
    return footer.magic == kEnd && footer.headerMagic == kBegin;
}

} // namespace

std::optional<ColorPacket> parseColorPacket(std::span<const std::byte> packet) {
    if (!endsWithFooter(packet)) return std::nullopt;
    const auto header = valueAt<Header>(packet, 0);
    const auto footer = valueAt<ColorFooter>(packet, packet.size() - sizeof(ColorFooter));
    const std::size_t body = packet.size() - sizeof(Header) - sizeof(ColorFooter);
    if (header.magic != kBegin || header.sequence != footer.sequence ||
        footer.packetBytes != packet.size() || footer.fillerBytes >= body)
        return std::nullopt;
    return ColorPacket{packet.subspan(sizeof(Header), body - footer.fillerBytes),
                       footer.sequence,
                       footer.timestamp,
                       footer.exposureMs,
                       footer.digitalGain,
                       footer.analogGain};
}

void ColorPackets::reset() {
    if (!complete_ && !bytes_.empty()) ++counters_.broken;
    bytes_.clear();
    complete_ = false;
}

std::optional<ColorPacket> ColorPackets::append(std::span<const std::byte> transfer) {
    if (complete_) reset();
    if (transfer.size() > kMostBytes - bytes_.size()) {
        bytes_.assign(1, std::byte{0}); // a loss, also where nothing came before it
        reset();
        return std::nullopt;
    }
    bytes_.insert(bytes_.end(), transfer.begin(), transfer.end());
    if (!endsWithFooter(bytes_)) return std::nullopt;
    const auto packet = parseColorPacket(bytes_);
    if (!packet) {
        reset();
        return std::nullopt;
    }
    complete_ = true;
    ++counters_.pictures;
    return packet;
}

} // namespace autostereo::devices::kinect2

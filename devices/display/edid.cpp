#include "devices/display/edid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace autostereo::devices {

namespace {

constexpr std::size_t kBlockBytes = 128;
constexpr std::size_t kMostBlocks = 256; // what the counter of extensions can say, and the base
constexpr std::size_t kDescriptorBytes = 18;
constexpr std::size_t kFirstDescriptor = 54;
constexpr std::size_t kDescriptors = 4;
constexpr std::size_t kExtensionCount = 126;
constexpr unsigned kCeaTag = 0x02;

/// A piece of an EDID; indices are the standard's.
class Block {
  public:
    explicit Block(std::span<const std::byte> bytes) : bytes_(bytes) {}

    [[nodiscard]] unsigned operator[](std::size_t i) const {
        return std::to_integer<unsigned>(bytes_[i]);
    }
    [[nodiscard]] bool bit(std::size_t i, unsigned number) const {
        return ((*this)[i] >> number & 1U) != 0;
    }
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    [[nodiscard]] Block part(std::size_t first, std::size_t count) const {
        return Block(bytes_.subspan(first, count));
    }
    /// 0 in a good block.
    [[nodiscard]] unsigned checksum() const {
        unsigned sum = 0;
        for (const std::byte byte : bytes_)
            sum += std::to_integer<unsigned>(byte);
        return sum & 0xffU;
    }

  private:
    std::span<const std::byte> bytes_;
};

std::string manufacturerOf(const Block& base) {
    const unsigned packed = base[8] << 8U | base[9];
    std::string letters;
    for (const unsigned shift : {10U, 5U, 0U}) {
        const unsigned letter = packed >> shift & 31U;
        letters += letter >= 1 && letter <= 26 ? static_cast<char>('A' + letter - 1) : '?';
    }
    return letters;
}

/// Text of a display descriptor: ends at a line feed, padded with spaces.
std::string textOf(const Block& descriptor) {
    std::string text;
    for (std::size_t i = 5; i < kDescriptorBytes; ++i) {
        const unsigned letter = descriptor[i];
        if (letter == '\n' || letter == 0) break;
        text += letter >= 0x20 && letter <= 0x7e ? static_cast<char>(letter) : '?';
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

void addTiming(const Block& timing, Edid& edid) {
    const double pixelsPerSecond = 1e4 * (timing[0] | timing[1] << 8U);
    const unsigned width = timing[2] | (timing[4] & 0xf0U) << 4U;
    const unsigned height = timing[5] | (timing[7] & 0xf0U) << 4U;
    const unsigned total = (width + (timing[3] | (timing[4] & 0x0fU) << 8U)) *
                           (height + (timing[6] | (timing[7] & 0x0fU) << 8U));
    edid.interlaced = timing.bit(17, 7);
    edid.nativeWidth = static_cast<int>(width);
    edid.nativeHeight = static_cast<int>(height) * (edid.interlaced ? 2 : 1);
    edid.refreshHz = total == 0 ? 0 : pixelsPerSecond / total;
    // Some put the aspect ratio there, 16 and 9 millimetres; the base block's centimetres are kept.
    const unsigned widthMm = timing[12] | (timing[14] & 0xf0U) << 4U;
    const unsigned heightMm = timing[13] | (timing[14] & 0x0fU) << 8U;
    if (widthMm >= 20 && heightMm >= 20) {
        edid.widthM = widthMm * 1e-3;
        edid.heightM = heightMm * 1e-3;
    }
}

void addDescriptors(const Block& base, Edid& edid) {
    for (std::size_t i = 0; i < kDescriptors; ++i) {
        const Block one = base.part(kFirstDescriptor + i * kDescriptorBytes, kDescriptorBytes);
        const bool isTiming = one[0] != 0 || one[1] != 0;
        if (isTiming && i == 0) addTiming(one, edid); // the first is the preferred one
        if (isTiming || one[2] != 0) continue;
        if (one[3] == 0xfc) edid.monitorName = textOf(one);
        if (one[3] == 0xff) edid.serialText = textOf(one);
    }
}

Edid parseBase(const Block& base) {
    Edid edid;
    edid.manufacturer = manufacturerOf(base);
    edid.product = static_cast<std::uint16_t>(base[10] | base[11] << 8U);
    edid.serialNumber = base[12] | base[13] << 8U | base[14] << 16U | base[15] << 24U;
    edid.digital = base.bit(20, 7);
    if (edid.digital && base[18] == 1 && base[19] >= 4) {
        const unsigned depth = base[20] >> 4U & 7U;
        if (depth >= 1 && depth <= 6) edid.bitsPerChannel = static_cast<int>(4 + 2 * depth);
    }
    if (base[21] != 0 && base[22] != 0) { // with one of them 0 the other is an aspect ratio
        edid.widthM = base[21] * 1e-2;
        edid.heightM = base[22] * 1e-2;
    }
    addDescriptors(base, edid);
    return edid;
}

/// `block` is the header byte and what it announces.
void addDataBlock(const Block& block, Edid& edid) {
    enum Tag { VendorSpecific = 3, Extended = 7 };
    enum ExtendedTag { VideoCapability = 0, Ycbcr420Modes = 14, Ycbcr420Capability = 15 };
    const unsigned tag = block[0] >> 5U;
    if (tag == VendorSpecific && block.size() >= 4) {
        const unsigned vendor = block[1] | block[2] << 8U | block[3] << 16U;
        if (vendor == 0x000c03 || vendor == 0xc45dd8) edid.hdmi = true; // HDMI 1.x, HDMI Forum
    }
    if (tag != Extended || block.size() < 2) return;
    if (block[1] == VideoCapability && block.size() >= 3) {
        edid.quantisationSelectable = block.bit(2, 6);
        edid.alwaysOverscans = (block[2] >> 2U & 3U) == 1;
    }
    if (block[1] == Ycbcr420Modes || block[1] == Ycbcr420Capability) edid.ycbcr420 = true;
}

/// Nothing, or what is wrong with its data blocks.
std::string addCea(const Block& block, Edid& edid) {
    edid.cea = true;
    if (block[1] >= 2) {
        edid.underscans = block.bit(3, 7);
        edid.ycbcr444 |= block.bit(3, 5);
        edid.ycbcr422 |= block.bit(3, 4);
    }
    const std::size_t end = block[2]; // where detailed timings begin; 0: neither these nor those
    if (block[1] < 3 || end == 0) return {};
    if (end < 4 || end >= kBlockBytes) return "its data blocks end outside of it";
    for (std::size_t at = 4; at < end;) {
        const std::size_t size = 1 + (block[at] & 0x1fU);
        if (at + size > end) return "a data block is longer than the room for it";
        addDataBlock(block.part(at, size), edid);
        at += size;
    }
    return {};
}

void addExtensions(const Block& all, Edid& edid) {
    const std::size_t blocks = all.size() / kBlockBytes;
    const std::size_t announced = 1 + all[kExtensionCount];
    if (blocks < announced)
        edid.faults.push_back(std::to_string(announced - 1) + " extension blocks are announced, " +
                              std::to_string(blocks - 1) + " are there");
    // There may be more than announced: HDMI 2.1 moved the real count into the first extension.
    for (std::size_t i = 1; i < blocks; ++i) {
        const Block block = all.part(i * kBlockBytes, kBlockBytes);
        std::string fault;
        if (block.checksum() != 0)
            fault = "its checksum is " + std::to_string(block.checksum()) + ", not 0";
        else if (block[0] == kCeaTag)
            fault = addCea(block, edid);
        if (!fault.empty())
            edid.faults.push_back("extension block " + std::to_string(i) + ": " + fault);
    }
}

} // namespace

std::variant<Edid, EdidError> parseEdid(std::span<const std::byte> bytes) {
    constexpr std::array<unsigned, 8> kHeader{0, 255, 255, 255, 255, 255, 255, 0};
    if (bytes.size() < kBlockBytes || bytes.size() % kBlockBytes != 0 ||
        bytes.size() > kMostBlocks * kBlockBytes)
        return EdidError{"edid: " + std::to_string(bytes.size()) +
                         " bytes are no whole blocks of 128 (allowed 1 to 256 blocks)"};
    const Block all(bytes);
    const Block base = all.part(0, kBlockBytes);
    for (std::size_t i = 0; i < kHeader.size(); ++i)
        if (base[i] != kHeader[i])
            return EdidError{"edid: byte " + std::to_string(i) + " is no EDID header's"};
    if (base.checksum() != 0)
        return EdidError{"edid: checksum of the base block is " + std::to_string(base.checksum()) +
                         ", not 0"};
    if (base[18] != 1)
        return EdidError{"edid: version " + std::to_string(base[18]) + " (allowed 1)"};
    Edid edid = parseBase(base);
    addExtensions(all, edid);
    return edid;
}

bool isLookingGlass(const Edid& edid) { return edid.monitorName.starts_with("LKG"); }

} // namespace autostereo::devices

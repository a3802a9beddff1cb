#include "devices/replay/png_decoder.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <stdexcept>
#include <vector>

#include <zlib.h>

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own entry

namespace {

std::uint32_t bigEndian(const std::vector<std::byte>& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = at; i < at + 4; ++i)
        value = value << 8U | std::to_integer<std::uint32_t>(bytes[i]);
    return value;
}

/// Good checksums of the chunks, which no mutation would find.
std::vector<std::byte> repaired(std::span<const std::byte> bytes) {
    constexpr std::size_t kSignature = 8, kAround = 12; // length, type and checksum of a chunk
    std::vector<std::byte> copy(bytes.begin(), bytes.end());
    for (std::size_t at = kSignature; at + kAround <= copy.size();) {
        const std::size_t length = bigEndian(copy, at);
        if (length > copy.size() - at - kAround) break;
        const auto* chunk = reinterpret_cast<const Bytef*>(copy.data() + at + 4);
        const auto sum = crc32(0, chunk, static_cast<uInt>(length + 4));
        for (std::size_t i = 0; i < 4; ++i)
            copy[at + 8 + length + i] = static_cast<std::byte>(sum >> (24 - 8 * i));
        at += length + kAround;
    }
    return copy;
}

void decode(std::span<const std::byte> bytes) try {
    constexpr std::size_t kLargest = 1U << 20U; // memory is not what is looked for
    devices::PngDecoder decoder;
    const auto header = decoder.open(bytes);
    fuzz::require(header.sizeAllowed(), "a picture of a wrong size");
    if (header.bytes() > kLargest) return;
    std::vector<std::byte> pixels(header.bytes());
    decoder.decode(pixels);
} catch (const std::runtime_error& error) {
    static_cast<void>(error); // in libpng's words: config makes it one line
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    decode(fuzz::bytesOf(data, size));
    decode(repaired(fuzz::bytesOf(data, size)));
    return 0;
}

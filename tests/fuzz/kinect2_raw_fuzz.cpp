#include "devices/kinect2/raw/raw_reader.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <cstring>
#include <sstream>

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own entry

// The input is a recording behind the format's name. Its first byte says how many records get the
// right checksum, which no fuzzer would find.

namespace {

using devices::kinect2::RawHeader;

std::string recording(std::span<const std::byte> bytes, unsigned right) {
    std::vector<std::byte> all(bytes.begin(), bytes.end());
    for (std::size_t at = 0; right > 0 && at + sizeof(RawHeader) <= all.size(); --right) {
        RawHeader header;
        std::memcpy(&header, all.data() + at, sizeof header);
        const std::size_t left = all.size() - at - sizeof header;
        if (header.payloadBytes > left) break;
        header.checksum =
            checksumOf(header, std::span(all).subspan(at + sizeof header, header.payloadBytes));
        std::memcpy(all.data() + at, &header.checksum, sizeof header.checksum);
        at += sizeof header + header.payloadBytes;
    }
    std::string text(devices::kinect2::kRawMagic.begin(), devices::kinect2::kRawMagic.end());
    return text.append(reinterpret_cast<const char*>(all.data()), all.size());
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto bytes = std::as_bytes(std::span(data, size)).subspan(1);
    devices::kinect2::RawReader reader(
        std::make_unique<std::istringstream>(recording(bytes, data[0])));
    fuzz::require(reader.isRecording(), "the name is there");
    devices::kinect2::RawRecord record;
    std::size_t records = 0;
    while (reader.next(record)) {
        ++records;
        fuzz::require(record.payload.size() <= size, "more than there is");
        if (record.header.kind != devices::kinect2::RawKind::Start) continue;
        const auto pages = reader.pages(record);
        if (!pages) continue;
        fuzz::require(pages->serial.size() <= 64 && pages->firmware.size() <= 64, "long names");
        try {
            static_cast<void>(parseFacts(*pages));
        } catch (const devices::DeviceError&) { // as good an answer
        }
    }
    fuzz::require(records * sizeof(RawHeader) <= size, "more records than fit");
    return 0;
}

#include "devices/kinect2/raw/raw_record.hpp"

#include <zlib.h>

namespace autostereo::devices::kinect2 {

std::uint32_t checksumOf(const RawHeader& header, std::span<const std::byte> payload) {
    const auto add = [](uLong sum, const void* bytes, std::size_t count) {
        return crc32_z(sum, static_cast<const Bytef*>(bytes), count);
    };
    uLong sum = crc32_z(0, nullptr, 0);
    sum = add(sum, &header.kind, sizeof header - sizeof header.checksum);
    if (!payload.empty()) sum = add(sum, payload.data(), payload.size());
    return static_cast<std::uint32_t>(sum);
}

} // namespace autostereo::devices::kinect2

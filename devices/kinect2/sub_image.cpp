#include "devices/kinect2/sub_image.hpp"

#include "devices/kinect2/little_endian.hpp"

namespace autostereo::devices::kinect2 {

namespace {

constexpr std::size_t kCodes = 2048;
constexpr unsigned kNegative = 1024; // the code's sign bit; alone it means "saturated"
constexpr unsigned kCodeBits = 11;

/// Steps of 1 for two blocks of 128 codes, then twice as long in each block.
constexpr std::array<std::int16_t, kCodes> makeCompanding() {
    constexpr unsigned kBlock = 128;
    std::array<std::int16_t, kCodes> table{};
    int magnitude = 0;
    for (unsigned code = 0; code < kNegative; ++code) {
        table[code] = static_cast<std::int16_t>(magnitude);
        table[kNegative + code] = static_cast<std::int16_t>(-magnitude);
        magnitude += code < kBlock ? 1 : 1 << (code / kBlock - 1);
    }
    table[kNegative] = kSaturated;
    return table;
}

constexpr std::array<std::int16_t, kCodes> kCompanding = makeCompanding();

} // namespace

const std::array<std::int16_t, 2048>& companding() { return kCompanding; }

void unpackRow(std::span<const std::byte, kSubImageBytes> subImage, int row,
               std::span<std::int16_t, kWidth> samples) {
    const int stored = row < kHeight / 2 ? row : kHeight / 2 + kHeight - 1 - row;
    const auto bytes = subImage.subspan(static_cast<std::size_t>(stored) * kRowBytes, kRowBytes);
    // Slots come in four runs of 128: columns 0, 4, 8 ..., then 1, 5, 9 ... Eight codes make 11
    // bytes, which two overlapping 64-bit words hold.
    constexpr std::size_t kInterleaved = 4, kGroup = 8, kGroupBytes = 11, kSecondWord = 3;
    constexpr std::size_t kGroupsInRun = kWidth / kInterleaved / kGroup;
    constexpr std::size_t kFromFirstWord = 5;
    for (std::size_t group = 0; group < kWidth / kGroup; ++group) {
        const auto first = valueAt<std::uint64_t>(bytes, group * kGroupBytes);
        const auto second = valueAt<std::uint64_t>(bytes, group * kGroupBytes + kSecondWord);
        std::int16_t* const out =
            samples.data() + group / kGroupsInRun + group % kGroupsInRun * kGroup * kInterleaved;
        for (std::size_t i = 0; i < kGroup; ++i) {
            const std::uint64_t code = i < kFromFirstWord
                                           ? first >> (kCodeBits * i)
                                           : second >> (kCodeBits * i - 8 * kSecondWord);
            out[i * kInterleaved] = kCompanding[code % kCodes];
        }
    }
}

} // namespace autostereo::devices::kinect2

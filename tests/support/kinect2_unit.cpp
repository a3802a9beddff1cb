#include "tests/support/kinect2_unit.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace autostereo::test {

namespace {

using namespace devices::kinect2;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kBaselineMm = 45;

/// Little-endian fields one after the other.
class Writer {
  public:
    template<class T>
    void put(const T& value) {
        const auto* first = reinterpret_cast<const std::byte*>(&value);
        bytes.insert(bytes.end(), first, first + sizeof value);
    }
    template<class... T>
    void putAll(const T&... values) {
        (put(values), ...);
    }
    void putU32(std::initializer_list<std::uint32_t> words) {
        for (const std::uint32_t word : words)
            put(word);
    }
    void append(std::span<const std::byte> more) {
        bytes.insert(bytes.end(), more.begin(), more.end());
    }

    Bytes bytes;
};

/// Nearest of the codes' values. Magnitudes grow by steps of 1, 1, 2, 4 ... 64 for 128 codes each.
unsigned codeOf(double sample) {
    static const std::vector<int> kMagnitudes = [] {
        std::vector<int> table{0};
        for (int block = 0; block < 8; ++block)
            for (int i = 0; i < 128; ++i)
                table.push_back(table.back() + (block < 2 ? 1 : 1 << (block - 1)));
        table.pop_back();
        return table;
    }();
    constexpr unsigned kNegative = 1024, kSaturatedCode = 1024;
    const double magnitude = std::abs(sample);
    if (magnitude > kMagnitudes.back() + 32) return kSaturatedCode;
    const auto above = std::ranges::lower_bound(kMagnitudes, magnitude);
    auto nearest = above;
    if (above == kMagnitudes.end() ||
        (above != kMagnitudes.begin() && *above - magnitude > magnitude - *std::prev(above)))
        nearest = std::prev(above);
    const auto code = static_cast<unsigned>(nearest - kMagnitudes.begin());
    return sample < 0 && code > 0 ? kNegative + code : code;
}

void storeCode(std::byte* subImage, int x, int y, unsigned code) {
    const int row = y < 212 ? y : 635 - y;
    const int slot = x / 4 + x % 4 * 128;
    for (int bit = 0; bit < 11; ++bit) {
        const int at = slot * 11 + bit;
        if ((code >> static_cast<unsigned>(bit) & 1U) != 0)
            subImage[row * 704 + at / 8] |= std::byte{1} << (at % 8);
    }
}

/// From laser to surface to lens.
double lightPathMm(const std::array<double, 2>& ray, double depthMm) {
    const double x = ray[0] * depthMm, y = ray[1] * depthMm;
    return std::hypot(x, y, depthMm) + std::hypot(x - kBaselineMm, y, depthMm);
}

} // namespace

Kinect2Unit inventedUnit() {
    Kinect2Unit unit;
    for (std::size_t i = 0; i < 3; ++i) {
        unit.offsets[i].resize(kPixels);
        for (std::size_t pixel = 0; pixel < kPixels; ++pixel) {
            const std::size_t x = pixel % kWidth, y = pixel / kWidth;
            unit.offsets[i][pixel] =
                static_cast<std::uint16_t>(9000 + 5000 * i + 3 * x + 2 * y + y % 2 * 32768);
        }
    }
    unit.xTerms = {1e-4F, 2e-5F, -3e-5F, 4e-5F, 2e-4F, -1e-4F, 3e-4F, 0.642F, 1.2e-3F, 0.031F};
    unit.yTerms = {-2e-5F, 1e-4F, 4e-5F, 3e-5F, -2e-4F, 1e-4F, 2e-4F, -1.1e-3F, 0.643F, -0.012F};
    return unit;
}

Bytes phasePage(const Kinect2Unit& unit) {
    constexpr std::uint32_t kGainBytes = 12, kDefectBytes = 6 + 70 * 4, kConfigBytes = 8;
    Writer page;
    page.putU32({32, 3, 6, kPixels * 2, 6, kGainBytes, kDefectBytes, kConfigBytes});
    constexpr std::array<std::uint16_t, 3> kMegahertz{80, 16, 120};
    for (std::size_t i = 0; i < 3; ++i) {
        page.put(kMegahertz[i]);
        page.append(std::as_bytes(std::span(unit.offsets[i])));
        page.put(unit.multipliers[i]);
    }
    page.bytes.resize(page.bytes.size() + kGainBytes);
    page.put(std::uint32_t{1});
    page.put(static_cast<std::uint16_t>(unit.defects.size()));
    for (const auto& defect : unit.defects)
        page.putAll(defect[0], defect[1]);
    page.bytes.resize(page.bytes.size() + (70 - unit.defects.size()) * 4 + kConfigBytes);
    return page.bytes;
}

Bytes depthCameraPage(const Kinect2Unit& unit) {
    Writer page;
    page.putAll(unit.fx, unit.fy, 0.0F, unit.cx, unit.cy, unit.k1, unit.k2, unit.p1, unit.p2,
                unit.k3);
    for (int i = 0; i < 12; ++i)
        page.put(i < 9 && i % 4 == 0 ? 1.0F : 0.0F);
    page.put(unit.zOffsetMm);
    return page.bytes;
}

Bytes colorPage(const Kinect2Unit& unit) {
    Writer page;
    page.put(std::uint8_t{1});
    page.putAll(unit.colorFocal, unit.colorCx, unit.colorCy, unit.nominalDepthMm,
                unit.displacementMm, unit.xTerms, unit.yTerms, unit.irCentroids,
                unit.colorCentroids, unit.checkDepthsMm);
    return page.bytes;
}

Bytes completion(std::uint32_t id, std::uint32_t status) {
    Writer reply;
    reply.putU32({0x0a6fe000, id, status, 0});
    return reply.bytes;
}

std::array<double, 2> rayOf(const Kinect2Unit& unit, int x, int y) {
    const double bentX = (x + 0.5 - unit.cx) / unit.fx, bentY = (y + 0.5 - unit.cy) / unit.fy;
    double rayX = bentX, rayY = bentY;
    for (int i = 0; i < 60; ++i) {
        const double r2 = rayX * rayX + rayY * rayY;
        const double radial = 1 + r2 * (unit.k1 + r2 * (unit.k2 + r2 * unit.k3));
        const double dx = 2 * unit.p1 * rayX * rayY + unit.p2 * (r2 + 2 * rayX * rayX);
        const double dy = unit.p1 * (r2 + 2 * rayY * rayY) + 2 * unit.p2 * rayX * rayY;
        rayX = (bentX - dx) / radial;
        rayY = (bentY - dy) / radial;
    }
    return {rayX, rayY};
}

RawDepthFrame expose(const Kinect2Unit& unit, const LitScene& scene, double sampleSigma,
                     std::mt19937_64& random) {
    constexpr std::array<double, 3> kPeriodMm{3 * 1250.0, 15 * 1250.0, 2 * 1250.0};
    std::normal_distribution<double> noise(0, 1);
    RawDepthFrame frame;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 1; x + 1 < kWidth; ++x) {
            const LitPoint point = scene(x, y);
            const double path = lightPathMm(rayOf(unit, x, y), point.depthMm - unit.zOffsetMm);
            for (std::size_t f = 0; f < 3; ++f) {
                const double offset = unit.offsets[f][static_cast<std::size_t>(y * kWidth + x)];
                const double turns = path / kPeriodMm[f] - offset / 65536;
                const double contrast = point.amplitude * unit.multipliers[1] / unit.multipliers[f];
                for (std::size_t i = 0; i < 3; ++i) {
                    const double wave = std::cos(kTurn * (turns + static_cast<double>(i) / 3));
                    const double sample =
                        contrast * wave + (sampleSigma > 0 ? sampleSigma * noise(random) : 0);
                    storeCode(frame.bytes.data() + (3 * f + i) * kSubImageBytes, x, y,
                              codeOf(sample));
                }
            }
        }
    }
    return frame;
}

std::vector<Bytes> depthPackets(const RawDepthFrame& frame) {
    constexpr std::size_t kPacket = 33792;
    std::vector<Bytes> packets;
    for (std::size_t i = 0; i < 10; ++i) {
        Writer whole;
        const std::size_t from = std::min<std::size_t>(i, 8);
        whole.append(std::span(frame.bytes).subspan(from * kSubImageBytes, kSubImageBytes));
        whole.putU32({9, 0, frame.timestamp, frame.sequence, static_cast<std::uint32_t>(i),
                      static_cast<std::uint32_t>(kSubImageBytes)});
        whole.bytes.resize(kSubImageBytes + 152);
        for (std::size_t at = 0; at < whole.bytes.size(); at += kPacket) {
            const auto first = whole.bytes.begin() + static_cast<std::ptrdiff_t>(at);
            const std::size_t count = std::min(kPacket, whole.bytes.size() - at);
            packets.emplace_back(first, first + static_cast<std::ptrdiff_t>(count));
        }
        packets.emplace_back();
    }
    return packets;
}

Bytes colorPacket(std::span<const std::byte> jpeg, std::uint32_t sequence,
                  std::uint32_t timestamp) {
    constexpr std::size_t kFooter = 56, kBlock = 1024;
    Writer packet;
    packet.putU32({sequence, 0x42424242});
    packet.append(jpeg);
    while (packet.bytes.size() % 4 != 0)
        packet.put(std::byte{0xa5});
    // So much that the footer does not end with a full USB packet, which would not end the
    // transfer.
    const std::size_t over = (packet.bytes.size() + kFooter) % kBlock;
    const std::size_t filler = over == 0 ? 4 : 0;
    packet.bytes.resize(packet.bytes.size() + filler, std::byte{'Z'});
    const auto total = static_cast<std::uint32_t>(packet.bytes.size() + kFooter);
    packet.putU32({0x39393939, sequence, static_cast<std::uint32_t>(filler), 0, 0, timestamp});
    packet.putAll(10.0F, 1.5F);
    packet.putU32({0x42424242, total});
    packet.put(2.5F);
    packet.putU32({0, 0, 0});
    return packet.bytes;
}

} // namespace autostereo::test

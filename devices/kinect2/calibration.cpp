#include "devices/kinect2/calibration.hpp"

#include "devices/input.hpp"
#include "devices/kinect2/little_endian.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::devices::kinect2 {

namespace {

[[noreturn]] void reject(const char* page, const std::string& why) {
    throw DeviceError(std::string("kinect2: the camera's ") + page +
                      " page cannot be used: " + why + " (unplug the camera, plug it in again)");
}

void needBytes(const char* page, std::span<const std::byte> bytes, std::size_t least) {
    if (bytes.size() < least)
        reject(page,
               std::to_string(bytes.size()) + " bytes, " + std::to_string(least) + " are needed");
}

// --- page 2: zero-phase offsets

constexpr const char* kPhasePage = "phase";
/// Of the reference driver.
constexpr std::array<double, kFrequencies> kUsualFactors{41.0 / 31, 1.0, 50.0 / 31};
constexpr double kMostFactor = 8; // beyond, or below 1/8: no calibration but garbage

struct PhaseHeader {
    std::uint32_t headerBytes;
    std::uint32_t frequencies;
    std::uint32_t frequencyTableBytes;
    std::uint32_t offsetTableBytes;
    std::uint32_t multiplierTableBytes;
    std::uint32_t gainBlockBytes;
    std::uint32_t defectBlockBytes;
    std::uint32_t configBlockBytes;
};

void readFactors(const std::array<std::uint16_t, kFrequencies>& multipliers,
                 PhaseCalibration& result) {
    result.amplitudeFactors = kUsualFactors;
    for (const std::uint16_t multiplier : multipliers) {
        const double factor = static_cast<double>(multiplier) / std::max<double>(multipliers[1], 1);
        if (!(factor <= kMostFactor && factor >= 1 / kMostFactor)) return;
    }
    result.ownAmplitudeFactors = true;
    for (std::size_t i = 0; i < kFrequencies; ++i)
        result.amplitudeFactors[i] = static_cast<double>(multipliers[i]) / multipliers[1];
}

/// u32 version, u16 count, 70 pairs of row and column.
void readDefects(std::span<const std::byte> block, PhaseCalibration& result) {
    constexpr std::size_t kCountAt = 4, kListAt = 6, kMost = 70, kEntry = 4;
    if (block.size() < kListAt) return;
    const std::size_t count = valueAt<std::uint16_t>(block, kCountAt);
    if (count > kMost || kListAt + count * kEntry > block.size()) {
        result.note = "its list of bad pixels says " + std::to_string(count) + " (allowed 0 to 70)";
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const auto row = valueAt<std::uint16_t>(block, kListAt + i * kEntry);
        const auto column = valueAt<std::uint16_t>(block, kListAt + i * kEntry + 2);
        if (row < kHeight && column < kWidth)
            result.defects.push_back(std::uint32_t{row} * kWidth + column);
        else
            result.note = "a bad pixel lies outside of the picture";
    }
}

// --- pages 3 and 4: cameras

struct DepthCameraPage {
    float focal[2], skew, centre[2], k1, k2, p1, p2, k3;
    float rotation[9], translation[3], zOffset;
};
static_assert(sizeof(DepthCameraPage) == 92);

constexpr std::size_t kColorPageBytes = 1 + 5 * 4 + 2 * 4 * ColorCalibration::kTerms +
                                        2 * sizeof(ColorCalibration::CheckPoints) +
                                        sizeof(ColorCalibration::CheckDepths);

} // namespace

PhaseCalibration parsePhasePage(std::span<const std::byte> page) {
    constexpr std::size_t kTableBytes = kPixels * sizeof(std::uint16_t);
    constexpr std::size_t kFrequencyBytes = kTableBytes + 2 * sizeof(std::uint16_t);
    needBytes(kPhasePage, page, sizeof(PhaseHeader) + kFrequencies * kFrequencyBytes);
    const auto header = valueAt<PhaseHeader>(page, 0);
    if (header.headerBytes != sizeof header || header.offsetTableBytes != kTableBytes)
        reject(kPhasePage, "a header of " + std::to_string(header.headerBytes) +
                               " bytes and tables of " + std::to_string(header.offsetTableBytes) +
                               " instead of 32 and 434176");
    PhaseCalibration result;
    std::array<std::uint16_t, kFrequencies> multipliers{};
    for (std::size_t i = 0; i < kFrequencies; ++i) {
        const auto block = page.subspan(sizeof header + i * kFrequencyBytes, kFrequencyBytes);
        const auto table = block.subspan(sizeof(std::uint16_t), kTableBytes);
        result.offsets[i].resize(kPixels);
        std::memcpy(result.offsets[i].data(), table.data(), kTableBytes);
        multipliers[i] = valueAt<std::uint16_t>(block, kFrequencyBytes - sizeof(std::uint16_t));
    }
    readFactors(multipliers, result);
    const auto tail = page.subspan(sizeof header + kFrequencies * kFrequencyBytes);
    const std::size_t defectsEnd =
        std::size_t{header.gainBlockBytes} + std::size_t{header.defectBlockBytes};
    if (defectsEnd <= tail.size())
        readDefects(tail.subspan(header.gainBlockBytes, header.defectBlockBytes), result);
    else
        result.note = "its list of bad pixels is cut off";
    return result;
}

DepthCamera parseDepthCameraPage(std::span<const std::byte> page) {
    constexpr const char* kName = "depth camera";
    constexpr double kMostOffsetMm = 100;
    needBytes(kName, page, sizeof(DepthCameraPage));
    const auto raw = valueAt<DepthCameraPage>(page, 0);
    DepthCamera camera;
    // The page counts from the corner of the first pixel.
    camera.model.intrinsics = {kWidth,
                               kHeight,
                               raw.focal[0],
                               raw.focal[1],
                               static_cast<double>(raw.centre[0]) - 0.5,
                               static_cast<double>(raw.centre[1]) - 0.5};
    auto& lens = camera.model.distortion;
    lens.k1 = raw.k1;
    lens.k2 = raw.k2;
    lens.p1 = raw.p1;
    lens.p2 = raw.p2;
    lens.k3 = raw.k3;
    if (const auto problem = calib::problemWith(camera.model)) reject(kName, *problem);
    if (!(std::abs(raw.zOffset) <= kMostOffsetMm))
        reject(kName,
               "a depth offset of " + std::to_string(raw.zOffset) + " mm (allowed -100 to 100)");
    camera.zOffsetMm = raw.zOffset;
    return camera;
}

ColorCalibration parseColorPage(std::span<const std::byte> page) {
    constexpr const char* kName = "colour camera";
    constexpr unsigned kVersion = 1;
    needBytes(kName, page, kColorPageBytes);
    FieldReader fields(page);
    const unsigned version = fields.next<std::uint8_t>();
    if (version != kVersion) reject(kName, "version " + std::to_string(version) + " (allowed 1)");
    ColorCalibration result;
    for (double* number :
         {&result.focal, &result.cx, &result.cy, &result.nominalDepthMm, &result.displacementMm})
        *number = fields.next<float>();
    for (auto* terms : {&result.xTerms, &result.yTerms})
        for (double& term : *terms)
            term = fields.next<float>();
    fields.fill(result.irCentroids);
    fields.fill(result.colorCentroids);
    fields.fill(result.checkDepthsMm);

    const auto finite = [](double number) { return std::isfinite(number); };
    if (!(result.focal > 0) || !(result.nominalDepthMm > 0) || !finite(result.focal) ||
        !finite(result.nominalDepthMm))
        reject(kName, "focal length or nominal depth is not positive");
    if (!finite(result.cx) || !finite(result.cy) || !finite(result.displacementMm) ||
        !std::ranges::all_of(result.xTerms, finite) || !std::ranges::all_of(result.yTerms, finite))
        reject(kName, "numbers that are not finite");
    return result;
}

} // namespace autostereo::devices::kinect2

#include "devices/input.hpp"
#include "devices/kinect2/phase_decoder.hpp"
#include "devices/kinect2/registration.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <cstring>

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own entry

namespace {

using namespace devices::kinect2;

/// The first 256 bytes are the page's header and the rest its tail, with tables of zeros between:
/// all that is looked at, in inputs of a size that a fuzzer can work with.
std::vector<std::byte> phasePageFrom(std::span<const std::byte> bytes) {
    constexpr std::size_t kHeader = 32, kMultiplier = 2;
    constexpr std::size_t kTables = kFrequencies * (2 * kPixels + 2 * kMultiplier);
    std::vector<std::byte> page(kHeader + kTables);
    const auto head = bytes.first(std::min(bytes.size(), kHeader));
    std::copy(head.begin(), head.end(), page.begin());
    page.insert(page.end(), bytes.begin() + static_cast<std::ptrdiff_t>(head.size()), bytes.end());
    return page;
}

void parsePhases(std::span<const std::byte> bytes) {
    for (const std::uint32_t defect : parsePhasePage(bytes).defects)
        fuzz::require(defect < kPixels, "a bad pixel outside of the picture");
}

void parseColor(std::span<const std::byte> bytes) {
    const auto color = parseColorPage(bytes);
    DepthCamera depth;
    depth.model.intrinsics = {kWidth, kHeight, 365, 365, 255, 211};
    const auto check = checkRegistration(color, depth);
    fuzz::require(check.points <= 644 && check.rmsPx >= 0, "a residual that cannot be");
}

template<class Parse>
void attempt(const Parse& parse, std::span<const std::byte> bytes) try {
    static_cast<void>(parse(bytes));
} catch (const devices::DeviceError& error) {
    fuzz::requirePlain(error.what());
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = fuzz::bytesOf(data, size);
    attempt(parsePhases, bytes);
    attempt(parsePhases, phasePageFrom(bytes));
    attempt(parseDepthCameraPage, bytes);
    // The page is longer than a fuzzer's inputs: zeros behind it.
    std::vector<std::byte> page(bytes.begin(), bytes.end());
    page.resize(std::max<std::size_t>(page.size(), 16384));
    attempt(parseColor, bytes);
    attempt(parseColor, page);
    return 0;
}

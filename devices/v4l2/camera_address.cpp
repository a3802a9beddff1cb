#include "devices/v4l2/camera_address.hpp"

#include "devices/input.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

namespace autostereo::devices::v4l2 {

namespace {

constexpr int kMostSide = 16384;

[[noreturn]] void refuse(const Uri& uri, const std::string& key, const std::string& allowed) {
    throw AddressError(uri.text + ": " + key + " = '" + uri.value(key) + "' (allowed " + allowed +
                       ")");
}

/// One of a few words; none where the key is absent.
template<class Value, std::size_t n>
std::optional<Value> choice(const Uri& uri, const std::string& key,
                            const std::array<std::pair<std::string_view, Value>, n>& words) {
    if (!uri.query.contains(key)) return std::nullopt;
    std::string allowed;
    for (const auto& [word, value] : words) {
        if (uri.value(key) == word) return value;
        allowed += (allowed.empty() ? "" : ", ") + std::string(word);
    }
    refuse(uri, key, allowed);
}

CameraName nameOf(const std::string& path) {
    constexpr std::string_view kSerial = "serial=";
    if (path.empty()) return {};
    if (path.starts_with(kSerial)) return {CameraName::By::Serial, path.substr(kSerial.size())};
    if (path.starts_with('/')) return {CameraName::By::Path, path};
    return {CameraName::By::Bus, path};
}

void readSize(const Uri& uri, ModeRequest& mode) {
    const std::string text = uri.value("size");
    if (!uri.query.contains("size")) return;
    int width = 0, height = 0;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%5dx%5d%c", &width, &height, &rest) != 2 || width < 1 ||
        height < 1 || width > kMostSide || height > kMostSide)
        refuse(uri, "size", "WIDTHxHEIGHT, 1x1 to 16384x16384");
    mode.width = width;
    mode.height = height;
}

void readFormat(const Uri& uri, ModeRequest& mode) {
    if (!uri.query.contains("format")) return;
    std::string allowed;
    for (const KnownFormat& known : knownFormats()) {
        if (uri.value("format") == text(known.code)) {
            mode.code = known.code;
            return;
        }
        allowed += (allowed.empty() ? "" : ", ") + text(known.code);
    }
    refuse(uri, "format", allowed);
}

} // namespace

CameraAddress cameraAddress(const Uri& uri) {
    uri.allowOnly({"as", "size", "fps", "format", "unit_mm", "exposure_ms", "power_line",
                   "white_balance", "zero_copy"});
    constexpr std::array<std::pair<std::string_view, Role>, 2> kRoles{
        {{"color", Role::Color}, {"depth", Role::Depth}}};
    constexpr std::array<std::pair<std::string_view, PowerLine>, 4> kPowerLines{
        {{"50", PowerLine::Hz50},
         {"60", PowerLine::Hz60},
         {"auto", PowerLine::Auto},
         {"off", PowerLine::Off}}};
    constexpr std::array<std::pair<std::string_view, bool>, 2> kZeroCopy{
        {{"auto", true}, {"off", false}}};
    CameraAddress address;
    address.text = uri.text;
    address.name = nameOf(uri.path);
    address.role = choice(uri, "as", kRoles);
    readSize(uri, address.mode);
    readFormat(uri, address.mode);
    if (!address.role && address.mode.code) address.role = knownFormat(*address.mode.code)->role;
    address.mode.framesPerSecond = uri.number("fps", 30, 0.1, 1000);
    address.depthUnitM = uri.number("unit_mm", 1, 0.001, 100) / 1000;
    address.controls.powerLine = choice(uri, "power_line", kPowerLines);
    address.zeroCopy = choice(uri, "zero_copy", kZeroCopy).value_or(true);
    if (uri.query.contains("exposure_ms"))
        address.controls.exposure = std::chrono::microseconds(
            std::llround(1000 * uri.number("exposure_ms", 8, 0.1, 10'000)));
    if (uri.query.contains("white_balance"))
        address.controls.whiteBalanceK =
            static_cast<int>(std::lround(uri.number("white_balance", 4600, 1000, 20'000)));
    return address;
}

} // namespace autostereo::devices::v4l2

#include "devices/display/drm_properties.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <string_view>

namespace autostereo::devices {

namespace {

using Properties = std::vector<DrmProperty>;

const DrmProperty* find(const Properties& properties, std::string_view name) {
    const auto found = std::ranges::find(properties, name, &DrmProperty::name);
    return found == properties.end() ? nullptr : &*found;
}

template<class Number>
Number numberAt(const std::vector<std::byte>& blob, std::size_t at) {
    Number number{};
    if (at + sizeof number <= blob.size()) std::memcpy(&number, blob.data() + at, sizeof number);
    return number;
}

/// Letters and digits in small: drivers disagree about "YCbCr 4:2:0", "ycbcr420" and "YCBCR420".
std::string plain(std::string_view word) {
    std::string letters;
    for (const char c : word)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return letters;
}

template<class Value>
struct Meaning {
    std::string_view word; ///< plain
    Value value;
};

template<class Value, std::size_t Count>
void read(const Properties& properties, std::string_view name,
          const Meaning<Value> (&meanings)[Count], std::optional<Value>& to) {
    const DrmProperty* property = find(properties, name);
    if (property == nullptr) return;
    const std::string word = plain(property->word);
    for (const auto& [known, value] : meanings)
        if (word == known) to = value;
}

constexpr Meaning<ColorRange> kRanges[]{{"full", ColorRange::Full},
                                        {"limited", ColorRange::Limited},
                                        {"limited16235", ColorRange::Limited},
                                        {"automatic", ColorRange::Automatic},
                                        {"auto", ColorRange::Automatic}};
constexpr Meaning<ColorFormat> kFormats[]{
    {"rgb", ColorFormat::Rgb},           {"rgb444", ColorFormat::Rgb},
    {"ycbcr444", ColorFormat::Ycbcr444}, {"yuv444", ColorFormat::Ycbcr444},
    {"ycbcr422", ColorFormat::Ycbcr422}, {"yuv422", ColorFormat::Ycbcr422},
    {"ycbcr420", ColorFormat::Ycbcr420}, {"yuv420", ColorFormat::Ycbcr420}};
constexpr Meaning<ModeScaling> kScalings[]{{"none", ModeScaling::None},
                                           {"full", ModeScaling::Full},
                                           {"center", ModeScaling::Center},
                                           {"fullaspect", ModeScaling::FullAspect}};
constexpr Meaning<bool> kDithering[]{
    {"off", false}, {"on", true}, {"static2x2", true}, {"dynamic2x2", true}, {"temporal", true}};
constexpr Meaning<bool> kLinks[]{{"good", true}, {"bad", false}};

void readBorder(const Properties& properties, LinkState& link) {
    const auto size = [&](std::string_view name) {
        const DrmProperty* property = find(properties, name);
        return property == nullptr
                   ? 0
                   : static_cast<int>(std::min<std::uint64_t>(property->value, 4096));
    };
    const DrmProperty* underscan = find(properties, "underscan");
    if (underscan != nullptr || find(properties, "left margin") != nullptr) link.border.emplace();
    if (!link.border) return;
    // "auto" shrinks on monitors that it takes for televisions; its border is 0 until it is set.
    if (underscan != nullptr && plain(underscan->word) != "off") {
        link.border->width += size("underscan hborder");
        link.border->height += size("underscan vborder");
    }
    link.border->width += std::max(size("left margin"), size("right margin"));
    link.border->height += std::max(size("top margin"), size("bottom margin"));
}

void readConnector(const Properties& properties, LinkState& link) {
    read(properties, "Broadcast RGB", kRanges, link.range);
    for (const char* name : {"color format", "active color format", "pixel encoding"})
        read(properties, name, kFormats, link.colorFormat);
    read(properties, "scaling mode", kScalings, link.modeScaling);
    read(properties, "dither", kDithering, link.dithering);
    read(properties, "dithering mode", kDithering, link.dithering);
    read(properties, "link-status", kLinks, link.linkGood);
    readBorder(properties, link);
    if (const auto* space = find(properties, "Colorspace");
        space != nullptr && !space->word.empty())
        link.colorSpace = space->word;
    if (const auto* bits = find(properties, "max bpc"); bits != nullptr && bits->value <= 16)
        link.maxBitsPerChannel = static_cast<int>(bits->value);
    if (const auto* hdr = find(properties, "HDR_OUTPUT_METADATA")) link.hdr = !hdr->blob.empty();
}

/// Entries of 8 bytes: red, green, blue, nothing, 16 bits each. No blob: no table.
std::optional<bool> isIdentityTable(const DrmProperty& property) {
    constexpr std::size_t kEntryBytes = 8;
    if (property.blob.size() % kEntryBytes != 0) return std::nullopt;
    std::vector<std::uint16_t> ramp(property.blob.size() / kEntryBytes);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        for (std::size_t i = 0; i < ramp.size(); ++i)
            ramp[i] = numberAt<std::uint16_t>(property.blob, i * kEntryBytes + 2 * channel);
        if (!isIdentityRamp(ramp)) return false;
    }
    return true;
}

/// Nine numbers of 64 bits: sign, then 31.32 fixed point.
std::optional<ColorMatrix> matrixOf(const DrmProperty& property) {
    constexpr std::size_t kSide = 3;
    if (property.blob.empty()) return ColorMatrix::Identity;
    if (property.blob.size() != kSide * kSide * sizeof(std::uint64_t)) return std::nullopt;
    constexpr double kTolerance = 0.5 / 255; // cannot change an 8-bit value
    ColorMatrix matrix = ColorMatrix::Identity;
    for (std::size_t i = 0; i < kSide * kSide; ++i) {
        const auto bits = numberAt<std::uint64_t>(property.blob, i * sizeof(std::uint64_t));
        const double size = std::ldexp(static_cast<double>(bits & ~(1ULL << 63U)), -32);
        const double entry = (bits >> 63U) != 0 ? -size : size;
        const bool diagonal = i % (kSide + 1) == 0;
        if (std::abs(entry - (diagonal ? 1 : 0)) <= kTolerance) continue;
        if (!diagonal) return ColorMatrix::Mixing;
        matrix = ColorMatrix::Scaling;
    }
    return matrix;
}

void readCrtc(const Properties& properties, LinkState& link) {
    // struct drm_mode_modeinfo: the width lies after the clock, flags after ten sizes and a rate.
    constexpr std::size_t kModeBytes = 68;
    constexpr std::size_t kWidthAt = 4;
    constexpr std::size_t kHeightAt = 14;
    constexpr std::size_t kFlagsAt = 28;
    constexpr std::uint32_t kInterlace = 1U << 4U;
    if (const auto* mode = find(properties, "MODE_ID"); mode && mode->blob.size() == kModeBytes) {
        link.mode = PixelSize{numberAt<std::uint16_t>(mode->blob, kWidthAt),
                              numberAt<std::uint16_t>(mode->blob, kHeightAt)};
        link.interlaced = (numberAt<std::uint32_t>(mode->blob, kFlagsAt) & kInterlace) != 0;
    }
    if (const auto* table = find(properties, "GAMMA_LUT"))
        link.gammaIsIdentity = isIdentityTable(*table);
    if (const auto* table = find(properties, "DEGAMMA_LUT"))
        link.degammaIsIdentity = isIdentityTable(*table);
    if (const auto* matrix = find(properties, "CTM")) link.colorMatrix = matrixOf(*matrix);
}

void readPlane(const Properties& properties, LinkState& link) {
    if (const auto* rotation = find(properties, "rotation")) {
        for (int quarter = 0; quarter < 4; ++quarter)
            if ((rotation->value >> quarter & 1U) != 0) link.rotationDeg = 90 * quarter;
        link.reflected = (rotation->value & 0x30U) != 0;
    }
    const auto size = [&](const char* width, const char* height, unsigned fractionBits) {
        const auto* w = find(properties, width);
        const auto* h = find(properties, height);
        std::optional<PixelSize> found;
        if (w != nullptr && h != nullptr && w->value != 0)
            found = PixelSize{static_cast<int>((w->value & 0xffffffffU) >> fractionBits),
                              static_cast<int>((h->value & 0xffffffffU) >> fractionBits)};
        return found;
    };
    link.source = size("SRC_W", "SRC_H", 16);
    link.shown = size("CRTC_W", "CRTC_H", 0);
    // Turned by a quarter the card shows a width as a height: that is no scaling.
    if (link.source && link.rotationDeg.value_or(0) % 180 != 0)
        std::swap(link.source->width, link.source->height);
}

} // namespace

LinkState linkStateOf(const DrmPipe& pipe) {
    LinkState link;
    readConnector(pipe.connectorProperties, link);
    readCrtc(pipe.crtcProperties, link);
    readPlane(pipe.planeProperties, link);
    return link;
}

LinkState linkOf(const Connector& monitor, std::span<const DrmPipe> pipes) {
    LinkState link;
    for (const DrmPipe& pipe : pipes)
        if (pipe.card == monitor.card && pipe.connector == monitor.name) link = linkStateOf(pipe);
    if (monitor.edid) addMonitor(*monitor.edid, link);
    return link;
}

} // namespace autostereo::devices

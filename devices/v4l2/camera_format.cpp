#include "devices/v4l2/camera_format.hpp"

#include <linux/videodev2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <tuple>

namespace autostereo::devices::v4l2 {

namespace {

/// In the order in which they are preferred.
constexpr std::array<KnownFormat, 13> kKnown{{
    {V4L2_PIX_FMT_NV12, Role::Color, PixelFormat::Nv12, false},
    {V4L2_PIX_FMT_YUYV, Role::Color, PixelFormat::Yuyv, false},
    {V4L2_PIX_FMT_UYVY, Role::Color, PixelFormat::Uyvy, false},
    {V4L2_PIX_FMT_RGB24, Role::Color, PixelFormat::Rgb8, false},
    {V4L2_PIX_FMT_BGR24, Role::Color, PixelFormat::Bgr8, false},
    {V4L2_PIX_FMT_XBGR32, Role::Color, PixelFormat::Bgra8, false},
    {V4L2_PIX_FMT_ABGR32, Role::Color, PixelFormat::Bgra8, false},
    {V4L2_PIX_FMT_BGR32, Role::Color, PixelFormat::Bgra8, false},
    {V4L2_PIX_FMT_MJPEG, Role::Color, PixelFormat::Rgba8, true},
    {V4L2_PIX_FMT_JPEG, Role::Color, PixelFormat::Rgba8, true},
    {V4L2_PIX_FMT_GREY, Role::Color, PixelFormat::Grey8, false},
    {V4L2_PIX_FMT_Z16, Role::Depth, PixelFormat::Depth16, false},
    {V4L2_PIX_FMT_Y16, Role::Depth, PixelFormat::Depth16, false},
}};

/// Cameras that run at 29.97 reach 30.
constexpr double kRateTolerance = 0.01;

bool allowed(const Mode& mode, const ModeRequest& request) {
    const KnownFormat* format = knownFormat(mode.code);
    return format != nullptr && format->role == request.role &&
           allowsSize(format->pixels, mode.width, mode.height) &&
           (!request.code || *request.code == mode.code) &&
           (!request.width || *request.width == mode.width) &&
           (!request.height || *request.height == mode.height);
}

double pixelsOf(const Mode& mode) { return static_cast<double>(mode.width) * mode.height; }

/// Less is better: too slow, by how much, the wrong size, by how much, the worse format.
auto cost(const Mode& mode, const ModeRequest& request) {
    const double rate = mode.period.count() > 0 ? 1e9 / static_cast<double>(mode.period.count())
                                                : request.framesPerSecond;
    const double missing = std::max(0.0, 1 - kRateTolerance - rate / request.framesPerSecond);
    constexpr double kWantedPixels = 1280.0 * 720.0;
    const double size = request.role == Role::Depth
                            ? -pixelsOf(mode)
                            : std::abs(std::log(pixelsOf(mode) / kWantedPixels));
    const double faster = std::max(0.0, rate - request.framesPerSecond);
    return std::tuple{missing, size, knownFormat(mode.code) - kKnown.data(), faster};
}

} // namespace

std::string text(FourCc code) {
    std::string letters;
    for (unsigned shift = 0; shift < 32; shift += 8) {
        const char letter = static_cast<char>(code >> shift & 0x7fU);
        letters += letter >= ' ' && letter != 0x7f ? letter : '?';
    }
    letters.erase(letters.find_last_not_of(' ') + 1);
    return letters;
}

std::string text(const Mode& mode) {
    std::string all =
        text(mode.code) + ' ' + std::to_string(mode.width) + 'x' + std::to_string(mode.height);
    if (mode.period.count() == 0) return all;
    char rate[32];
    std::snprintf(rate, sizeof rate, " %.4g fps", 1e9 / static_cast<double>(mode.period.count()));
    return all + rate;
}

std::span<const KnownFormat> knownFormats() { return kKnown; }

const KnownFormat* knownFormat(FourCc code) {
    const auto* found = std::ranges::find(kKnown, code, &KnownFormat::code);
    return found == kKnown.end() ? nullptr : found;
}

std::optional<Mode> chooseMode(std::span<const Mode> offered, const ModeRequest& request) {
    std::optional<Mode> best;
    for (const Mode& mode : offered) {
        if (!allowed(mode, request)) continue;
        if (!best || cost(mode, request) < cost(*best, request)) best = mode;
    }
    return best;
}

YuvMeaning yuvMeaning(std::uint32_t colorspace, std::uint32_t encoding,
                      std::uint32_t quantization) {
    if (colorspace == V4L2_COLORSPACE_DEFAULT && encoding == V4L2_YCBCR_ENC_DEFAULT) return {};
    if (encoding == V4L2_YCBCR_ENC_DEFAULT) encoding = V4L2_MAP_YCBCR_ENC_DEFAULT(colorspace);
    if (quantization == V4L2_QUANTIZATION_DEFAULT)
        quantization = V4L2_MAP_QUANTIZATION_DEFAULT(false, colorspace, encoding);
    const bool standard = encoding == V4L2_YCBCR_ENC_601 || encoding == V4L2_YCBCR_ENC_XV601;
    return {standard ? YuvMatrix::Bt601 : YuvMatrix::Bt709,
            quantization == V4L2_QUANTIZATION_FULL_RANGE ? YuvRange::Full : YuvRange::Limited};
}

} // namespace autostereo::devices::v4l2

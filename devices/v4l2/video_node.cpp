#include "devices/v4l2/video_node.hpp"

#include "devices/input.hpp"
#include "devices/v4l2/node_holders.hpp"

#include <fcntl.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace autostereo::devices::v4l2 {

namespace {

/// Drivers number what they list and say EINVAL at the end; a broken one may never.
constexpr std::uint32_t kMostListed = 128;
constexpr int kMostSide = 16384;

template<std::size_t n>
std::string field(const __u8 (&text)[n]) {
    const auto* letters = reinterpret_cast<const char*>(text);
    std::string all(letters, strnlen(letters, n));
    std::ranges::replace_if(
        all, [](char c) { return static_cast<unsigned char>(c) < ' '; }, '?');
    return all;
}

Duration durationOf(const v4l2_fract& seconds) {
    if (seconds.denominator == 0) return Duration(0);
    return Duration(static_cast<Duration::rep>(1e9 * seconds.numerator / seconds.denominator));
}

std::string adviceFor(int error, const std::string& path) {
    if (error == EACCES || error == EPERM)
        return " (join group video, or install systemd/70-autostereo.rules)";
    if (error == EBUSY) {
        const std::string holders = holdersOf(path);
        return holders.empty() ? " (is another program using it?)" : " (in use by " + holders + ")";
    }
    return {};
}

/// Sizes that cameras have, for drivers that take any.
constexpr std::array<std::array<int, 2>, 4> kUsualSizes{
    {{640, 480}, {1280, 720}, {1920, 1080}, {320, 240}}};

} // namespace

VideoNode::VideoNode(const std::filesystem::path& path)
    : path_(path.string()), fd_(::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC)) {
    if (!fd_) {
        const int error = errno;
        throw DeviceError("v4l2: cannot open " + path_ + ": " + std::strerror(error) +
                              adviceFor(error, path_),
                          error == ENOENT || error == ENODEV || error == ENXIO);
    }
    v4l2_capability about{};
    if (control(VIDIOC_QUERYCAP, about) != 0)
        throw DeviceError("v4l2: cannot open " + path_ + ": it is no V4L2 device");
    card_ = field(about.card);
    bus_ = field(about.bus_info);
    driver_ = field(about.driver);
    // What this node does, not what the device as a whole does.
    const std::uint32_t does =
        (about.capabilities & V4L2_CAP_DEVICE_CAPS) != 0 ? about.device_caps : about.capabilities;
    constexpr std::uint32_t kNeeded = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
    captures_ = (does & kNeeded) == kNeeded;
}

int VideoNode::controlRaw(unsigned long request, void* argument) const {
    int result = 0;
    do {
        result = ::ioctl(fd_.get(), request, argument);
    } while (result < 0 && errno == EINTR);
    return result < 0 ? errno : 0;
}

void VideoNode::fail(const char* tried, const char* request, int error) const {
    throw DeviceError("v4l2: cannot " + std::string(tried) + " " + path_ + ": " + request + ": " +
                          std::strerror(error) + adviceFor(error, path_),
                      error == ENODEV);
}

std::vector<Mode> VideoNode::modes(const ModeRequest& wanted) const {
    std::vector<Mode> all;
    for (std::uint32_t i = 0; i < kMostListed; ++i) {
        v4l2_fmtdesc format{};
        format.index = i;
        format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
        if (control(VIDIOC_ENUM_FMT, format) != 0) break;
        if (knownFormat(format.pixelformat) != nullptr) addSizes(format.pixelformat, wanted, all);
    }
    return all;
}

void VideoNode::addSizes(FourCc code, const ModeRequest& wanted, std::vector<Mode>& modes) const {
    for (std::uint32_t i = 0; i < kMostListed; ++i) {
        v4l2_frmsizeenum size{};
        size.index = i;
        size.pixel_format = code;
        if (control(VIDIOC_ENUM_FRAMESIZES, size) != 0) return;
        if (size.type == V4L2_FRMSIZE_TYPE_DISCRETE) {
            if (size.discrete.width > kMostSide || size.discrete.height > kMostSide) continue;
            addPeriods({code, static_cast<int>(size.discrete.width),
                        static_cast<int>(size.discrete.height)},
                       wanted, modes);
            continue;
        }
        const auto fits = [&](int width, int height) {
            const auto w = static_cast<std::uint32_t>(width),
                       h = static_cast<std::uint32_t>(height);
            return w >= size.stepwise.min_width && w <= size.stepwise.max_width &&
                   h >= size.stepwise.min_height && h <= size.stepwise.max_height;
        };
        if (wanted.width && wanted.height && fits(*wanted.width, *wanted.height))
            addPeriods({code, *wanted.width, *wanted.height}, wanted, modes);
        for (const auto& [width, height] : kUsualSizes)
            if (fits(width, height)) addPeriods({code, width, height}, wanted, modes);
        return;
    }
}

void VideoNode::addPeriods(const Mode& size, const ModeRequest& wanted,
                           std::vector<Mode>& modes) const {
    Mode mode = size;
    for (std::uint32_t i = 0; i < kMostListed; ++i) {
        v4l2_frmivalenum period{};
        period.index = i;
        period.pixel_format = size.code;
        period.width = static_cast<std::uint32_t>(size.width);
        period.height = static_cast<std::uint32_t>(size.height);
        if (control(VIDIOC_ENUM_FRAMEINTERVALS, period) != 0) {
            if (i == 0) modes.push_back(mode); // the driver doesn't say
            return;
        }
        if (period.type == V4L2_FRMIVAL_TYPE_DISCRETE) {
            mode.period = durationOf(period.discrete);
            modes.push_back(mode);
            continue;
        }
        const Duration asked(static_cast<Duration::rep>(1e9 / wanted.framesPerSecond));
        const Duration least = durationOf(period.stepwise.min);
        mode.period = std::clamp(asked, least, std::max(least, durationOf(period.stepwise.max)));
        modes.push_back(mode);
        return;
    }
}

} // namespace autostereo::devices::v4l2

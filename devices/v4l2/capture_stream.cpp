#include "devices/v4l2/capture_stream.hpp"

#include "devices/input.hpp"
#include "devices/v4l2/unpack.hpp"

#include <linux/videodev2.h>
#include <poll.h>
#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

namespace autostereo::devices::v4l2 {

namespace {

constexpr std::uint32_t kBuffers = 4;
constexpr std::uint32_t kCapture = V4L2_BUF_TYPE_VIDEO_CAPTURE;

v4l2_buffer bufferRequest(std::uint32_t index = 0) {
    v4l2_buffer buffer{};
    buffer.type = kCapture;
    buffer.memory = V4L2_MEMORY_MMAP;
    buffer.index = index;
    return buffer;
}

/// 64 bits: a damaged stamp may hold any seconds.
Duration durationOf(const timeval& time) {
    constexpr std::uint64_t kSecond = 1'000'000'000, kMicrosecond = 1000;
    return Duration(
        static_cast<Duration::rep>(static_cast<std::uint64_t>(time.tv_sec) * kSecond +
                                   static_cast<std::uint64_t>(time.tv_usec) * kMicrosecond));
}

StampOf stampOf(std::uint32_t flags, bool uvc) {
    if ((flags & V4L2_BUF_FLAG_TSTAMP_SRC_MASK) != V4L2_BUF_FLAG_TSTAMP_SRC_SOE)
        return StampOf::FrameEnd;
    return uvc ? StampOf::ReceptionStart : StampOf::ExposureStart;
}

} // namespace

CaptureStream::Mapping::Mapping(int fd, std::size_t length, std::int64_t offset) {
    void* data = ::mmap(nullptr, length, PROT_READ, MAP_SHARED, fd, offset);
    if (data == MAP_FAILED) return;
    data_ = static_cast<std::byte*>(data);
    length_ = length;
}

CaptureStream::Mapping::Mapping(Mapping&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), length_(std::exchange(other.length_, 0)) {}

CaptureStream::Mapping::~Mapping() {
    if (data_ != nullptr) ::munmap(data_, length_);
}

CaptureStream::CaptureStream(VideoNode node, const Mode& mode) : node_(std::move(node)) {
    agreeOn(mode);
    mapBuffers();
    start();
}

CaptureStream::~CaptureStream() {
    if (node_.fd() < 0) return; // moved from
    std::uint32_t type = kCapture;
    static_cast<void>(node_.control(VIDIOC_STREAMOFF, type)); // ENODEV where it is gone
}

void CaptureStream::agreeOn(const Mode& mode) {
    v4l2_format format{};
    format.type = kCapture;
    format.fmt.pix.width = static_cast<std::uint32_t>(mode.width);
    format.fmt.pix.height = static_cast<std::uint32_t>(mode.height);
    format.fmt.pix.pixelformat = mode.code;
    format.fmt.pix.field = V4L2_FIELD_NONE;
    if (const int error = node_.control(VIDIOC_S_FMT, format))
        node_.fail("use", "VIDIOC_S_FMT", error);
    const v4l2_pix_format& got = format.fmt.pix;
    const KnownFormat* known = knownFormat(got.pixelformat);
    if (known == nullptr || got.pixelformat != mode.code)
        throw DeviceError("v4l2: cannot use " + node_.path() + ": asked for " + text(mode) +
                          ", it gives " + text(got.pixelformat));
    agreed_.mode = {got.pixelformat, static_cast<int>(got.width), static_cast<int>(got.height),
                    mode.period};
    agreed_.stride = got.bytesperline;
    agreed_.yuv = yuvMeaning(got.colorspace, got.ycbcr_enc, got.quantization);
    constexpr std::uint32_t kMostSide = 16384;
    if (got.width > kMostSide || got.height > kMostSide ||
        (!known->jpeg &&
         bufferBytes(known->pixels, agreed_.mode.width, agreed_.mode.height, agreed_.stride) == 0))
        throw DeviceError("v4l2: cannot use " + node_.path() + ": " + text(agreed_.mode) +
                          " with rows of " + std::to_string(agreed_.stride) + " bytes cannot be");

    v4l2_streamparm rate{};
    rate.type = kCapture;
    constexpr std::uint32_t kTenMHz = 10'000'000; // UVC's own unit
    rate.parm.capture.timeperframe = {static_cast<std::uint32_t>(mode.period.count() / 100),
                                      kTenMHz};
    if (mode.period.count() > 0) static_cast<void>(node_.control(VIDIOC_S_PARM, rate));
    // What it snapped to, if it says.
    if (node_.control(VIDIOC_G_PARM, rate) == 0 && rate.parm.capture.timeperframe.denominator != 0)
        agreed_.mode.period =
            Duration(static_cast<Duration::rep>(1e9 * rate.parm.capture.timeperframe.numerator /
                                                rate.parm.capture.timeperframe.denominator));
}

void CaptureStream::mapBuffers() {
    v4l2_requestbuffers request{};
    request.count = kBuffers;
    request.type = kCapture;
    request.memory = V4L2_MEMORY_MMAP;
    if (const int error = node_.control(VIDIOC_REQBUFS, request))
        node_.fail("get buffers of", "VIDIOC_REQBUFS", error);
    for (std::uint32_t i = 0; i < request.count && i < VIDEO_MAX_FRAME; ++i) {
        v4l2_buffer buffer = bufferRequest(i);
        if (const int error = node_.control(VIDIOC_QUERYBUF, buffer))
            node_.fail("get buffers of", "VIDIOC_QUERYBUF", error);
        buffers_.emplace_back(node_.fd(), buffer.length, std::int64_t{buffer.m.offset});
        if (buffers_.back().bytes().empty()) node_.fail("map buffers of", "mmap", errno);
    }
}

void CaptureStream::start() {
    for (std::uint32_t i = 0; i < buffers_.size(); ++i)
        if (queue(i) != 0) refused_.push_back(i);
    std::uint32_t type = kCapture;
    if (const int error = node_.control(VIDIOC_STREAMON, type))
        node_.fail("stream from", "VIDIOC_STREAMON", error);
}

int CaptureStream::queue(std::uint32_t buffer) {
    v4l2_buffer request = bufferRequest(buffer);
    return node_.control(VIDIOC_QBUF, request);
}

void CaptureStream::giveBack(const Captured& captured) {
    if (queue(captured.buffer) != 0) refused_.push_back(captured.buffer);
}

CaptureStream::Outcome CaptureStream::wait(TimePoint deadline) {
    for (const std::uint32_t buffer : std::exchange(refused_, {}))
        if (queue(buffer) != 0) refused_.push_back(buffer);
    const Duration left = std::clamp<Duration>(deadline - std::chrono::steady_clock::now(),
                                               Duration(0), std::chrono::seconds(1));
    const timespec timeout{left.count() / 1'000'000'000, left.count() % 1'000'000'000};
    pollfd camera{node_.fd(), POLLIN, 0};
    if (::ppoll(&camera, 1, &timeout, nullptr) <= 0) return Nothing{};
    return dequeue((camera.revents & (POLLERR | POLLHUP | POLLNVAL)) != 0);
}

CaptureStream::Outcome CaptureStream::dequeue(bool errorSeen) {
    v4l2_buffer buffer = bufferRequest();
    const int error = node_.control(VIDIOC_DQBUF, buffer);
    if (error == EAGAIN && !errorSeen) return Nothing{};
    if (error != 0) return Broken{error == EAGAIN ? "poll: device error" : std::strerror(error)};
    if (buffer.index >= buffers_.size()) return Broken{"the driver gave a buffer that is not ours"};
    const std::span<const std::byte> all = buffers_[buffer.index].bytes();
    Captured captured;
    captured.bytes = all.first(std::min<std::size_t>(buffer.bytesused, all.size()));
    captured.sequence = buffer.sequence;
    captured.stamp = durationOf(buffer.timestamp);
    captured.stampOf = stampOf(buffer.flags, node_.driver() == "uvcvideo");
    captured.damaged = (buffer.flags & V4L2_BUF_FLAG_ERROR) != 0;
    captured.buffer = buffer.index;
    return captured;
}

} // namespace autostereo::devices::v4l2

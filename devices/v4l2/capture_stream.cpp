#include "devices/v4l2/capture_stream.hpp"

#include "devices/input.hpp"
#include "devices/v4l2/unpack.hpp"

#include <linux/videodev2.h>
#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

namespace autostereo::devices::v4l2 {

namespace {

/// As many as are left while one of the driver's own four is read: with fewer a frame is lost as
/// soon as this thread is late.
constexpr std::uint32_t kLeastQueued = 3;

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

CaptureStream::CaptureStream(VideoNode node, const Mode& mode) : node_(std::move(node)) {
    agreeOn(mode);
    buffers_ = CaptureBuffers::drivers(node_, false);
    start();
}

CaptureStream::~CaptureStream() {
    if (node_.fd() >= 0) stop(); // else moved from
}

void CaptureStream::stop() {
    std::uint32_t type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    static_cast<void>(node_.control(VIDIOC_STREAMOFF, type)); // ENODEV where it is gone
}

void CaptureStream::agreeOn(const Mode& mode) {
    v4l2_format format{};
    format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
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
    agreed_.pictureBytes = got.sizeimage;
    agreed_.yuv = yuvMeaning(got.colorspace, got.ycbcr_enc, got.quantization);
    constexpr std::uint32_t kMostSide = 16384;
    if (got.width > kMostSide || got.height > kMostSide ||
        (!known->jpeg &&
         bufferBytes(known->pixels, agreed_.mode.width, agreed_.mode.height, agreed_.stride) == 0))
        throw DeviceError("v4l2: cannot use " + node_.path() + ": " + text(agreed_.mode) +
                          " with rows of " + std::to_string(agreed_.stride) + " bytes cannot be");

    v4l2_streamparm rate{};
    rate.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
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

void CaptureStream::start() {
    buffers_->queueFree(node_);
    std::uint32_t type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (const int error = node_.control(VIDIOC_STREAMON, type))
        node_.fail("stream from", "VIDIOC_STREAMON", error);
}

void CaptureStream::useBuffers(PixelWay way, PixelMemory* memory, const BufferShape& shape) {
    stop();
    buffers_.reset(); // before the driver is asked for others: it may refuse while any is mapped
    way_ = PixelWay::Copied;
    buffers_ = way == PixelWay::Filled && memory != nullptr
                   ? CaptureBuffers::filled(node_, *memory, shape)
                   : CaptureBuffers::drivers(node_, way == PixelWay::Exported);
    if (way == PixelWay::Filled)
        if (const int error = buffers_->queue(node_, 0))
            node_.fail("give the GPU's buffers to", "VIDIOC_QBUF", error);
    start();
    way_ = way;
}

void CaptureStream::giveBack(const Captured& captured) {
    buffers_->release(captured.buffer);
    static_cast<void>(buffers_->queue(node_, captured.buffer)); // refused: with the next `wait`
}

std::shared_ptr<const SharedPixels>
CaptureStream::lend(const Captured& captured, std::shared_ptr<PixelSharing> sharing) const {
    if (way_ == PixelWay::Copied || buffers_->queued() < kLeastQueued) return nullptr;
    return buffers_->lend(captured.buffer, std::move(sharing), way_, agreed_.stride);
}

CaptureStream::Outcome CaptureStream::wait(TimePoint deadline) {
    if (!buffers_) return Broken{"it has no buffers"};
    buffers_->queueFree(node_);
    const Duration left = std::clamp<Duration>(deadline - std::chrono::steady_clock::now(),
                                               Duration(0), std::chrono::seconds(1));
    const timespec timeout{left.count() / 1'000'000'000, left.count() % 1'000'000'000};
    pollfd camera{node_.fd(), POLLIN, 0};
    if (::ppoll(&camera, 1, &timeout, nullptr) <= 0) return Nothing{};
    return dequeue((camera.revents & (POLLERR | POLLHUP | POLLNVAL)) != 0);
}

CaptureStream::Outcome CaptureStream::dequeue(bool errorSeen) {
    v4l2_buffer buffer{};
    buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    buffer.memory = buffers_->memory();
    const int error = node_.control(VIDIOC_DQBUF, buffer);
    if (error == EAGAIN && !errorSeen) return Nothing{};
    if (error != 0) return Broken{error == EAGAIN ? "poll: device error" : std::strerror(error)};
    if (buffer.index >= buffers_->count())
        return Broken{"the driver gave a buffer that is not ours"};
    buffers_->take(buffer.index);
    const std::span<const std::byte> all = buffers_->bytes(buffer.index);
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

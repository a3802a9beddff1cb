#include "devices/v4l2/v4l2_source.hpp"

#include "devices/v4l2/camera_controls.hpp"
#include "devices/v4l2/unpack.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace autostereo::devices::v4l2 {

namespace {} // namespace

V4l2Source::V4l2Source(CaptureStream stream, double depthUnitM, const ControlParams& controls,
                       std::shared_ptr<Continuity> continuity)
    : stream_(std::move(stream)), format_(*knownFormat(stream_.agreed().mode.code)),
      depthUnitM_(depthUnitM), controls_(controls), continuity_(std::move(continuity)) {
    const Agreed& agreed = stream_.agreed();
    const bool packed =
        bufferBytes(format_.pixels, agreed.mode.width, agreed.mode.height, agreed.stride) ==
        frameBytes(format_.pixels, agreed.mode.width, agreed.mode.height);
    if (continuity_->sharing && format_.role == Role::Color && !format_.jpeg && packed) {
        sharing_ = continuity_->sharing;
        auto invitation = std::make_shared<SharedPixels>();
        invitation->sharing = sharing_;
        invites_ = std::move(invitation);
    }
    begin();
}

void V4l2Source::begin() {
    sequence_ = SequenceCounter(continuity_->nextSequence);
    continuity_->silence.start(steadyNow(), stream_.agreed().mode.period);
}

void V4l2Source::followSharing() {
    if (!sharing_) return;
    for (PixelWay way = sharing_->way(); way != stream_.way(); way = sharing_->way()) {
        // The driver's own stay what they are, but are lent no more.
        if (way == PixelWay::Copied && stream_.way() == PixelWay::Exported) return;
        const Agreed& agreed = stream_.agreed();
        const BufferShape shape{agreed.stride, static_cast<std::size_t>(agreed.mode.height),
                                agreed.pictureBytes};
        try {
            stream_.useBuffers(way, sharing_->memory().get(), shape);
            // Some cameras forget them when a stream starts.
            static_cast<void>(setControls(stream_.node(), controls_));
        } catch (const std::exception& error) {
            if (way == PixelWay::Copied) throw;
            sharing_->refuse(way, error.what());
        }
        begin();
    }
}

ReadResult V4l2Source::read(TimePoint deadline) noexcept try {
    followSharing();
    // Damaged frames do not keep a caller longer than it wants.
    do {
        const TimePoint quietAt = continuity_->silence.deadline();
        const auto outcome = stream_.wait(std::min(deadline, quietAt));
        if (const auto* broken = std::get_if<CaptureStream::Broken>(&outcome))
            return Disconnected{stream_.node().path() + ": " + broken->reason};
        if (const auto* captured = std::get_if<Captured>(&outcome)) {
            auto frame = convert(*captured);
            const bool lent = frame && frame->shared() && frame->shared()->fd >= 0;
            if (!lent) stream_.giveBack(*captured);
            if (frame) return std::move(*frame);
        } else if (steadyNow() >= quietAt) {
            return silent();
        }
    } while (steadyNow() < deadline);
    return Timeout{};
} catch (const std::exception& error) {
    return Disconnected{stream_.node().path() + ": " + error.what()};
}

ReadResult V4l2Source::silent() {
    continuity_->silence.expired();
    return Disconnected{stream_.node().path() + ": no frame comes any more"};
}

void V4l2Source::lookAtExposure(TimePoint time) {
    if (time < askExposureAt_) return;
    askExposureAt_ = time + std::chrono::seconds(1); // automatic exposure changes slowly
    exposure_ = exposureOf(stream_.node());
    if (const Duration period = stream_.agreed().mode.period; period.count() > 0)
        exposure_ = std::min(exposure_, 8 * period); // a value that nobody set may be anything
}

/// Nothing: dropped and counted.
std::optional<Frame> V4l2Source::convert(const Captured& captured) {
    const TimePoint time = steadyNow();
    lookAtExposure(time);
    continuity_->silence.frame(time, exposure_);
    const std::uint64_t sequence = sequence_.map(captured.sequence);
    continuity_->nextSequence = sequence + 1;
    if (captured.damaged) {
        ++counters_.damaged;
        return std::nullopt;
    }
    auto frame = format_.jpeg ? decode(captured) : lend(captured);
    if (!frame && !format_.jpeg) frame = copy(captured);
    if (!frame) return std::nullopt;
    frame->metadata().sequence = sequence;
    frame->metadata().capturedAt =
        clock_.midExposure(captured.stamp, captured.stampOf, exposure_, time);
    ++counters_.delivered;
    return frame;
}

FrameMetadata V4l2Source::form() const {
    const Agreed& agreed = stream_.agreed();
    FrameMetadata metadata;
    metadata.format = format_.pixels;
    metadata.width = agreed.mode.width;
    metadata.height = agreed.mode.height;
    metadata.depthUnitM = depthUnitM_;
    metadata.matrix = agreed.yuv.matrix;
    metadata.range = agreed.yuv.range;
    return metadata;
}

std::optional<Frame> V4l2Source::slot(std::size_t encodedBytes) {
    FrameMetadata metadata = form();
    metadata.encodedBytes = encodedBytes;
    auto frame = pool_.acquire(metadata);
    if (!frame) ++counters_.starved;
    return frame;
}

/// Nothing: it has to be copied.
std::optional<Frame> V4l2Source::lend(const Captured& captured) {
    if (!sharing_ || sharing_->way() != stream_.way()) return std::nullopt;
    const FrameMetadata metadata = form();
    if (captured.bytes.size() < frameBytes(metadata.format, metadata.width, metadata.height))
        return std::nullopt; // damaged, and counted as such
    auto shared = stream_.lend(captured, sharing_);
    if (!shared) return std::nullopt;
    // Mapped for reading; frames of this kind are only read.
    auto* first = const_cast<std::byte*>(captured.bytes.data());
    return Frame({first, captured.bytes.size()}, metadata, std::move(shared));
}

std::optional<Frame> V4l2Source::decode(const Captured& captured) try {
    const Mode& mode = stream_.agreed().mode;
    const ImageHeader header = jpeg_.open(captured.bytes);
    if (header.size() != PictureSize{mode.width, mode.height}) {
        ++counters_.damaged;
        return std::nullopt;
    }
    auto frame = slot(captured.bytes.size());
    if (!frame) return std::nullopt;
    jpeg_.decode(frame->pixels());
    std::ranges::copy(captured.bytes, frame->encoded().begin());
    return frame;
} catch (const std::exception&) {
    ++counters_.damaged;
    return std::nullopt;
}

std::optional<Frame> V4l2Source::copy(const Captured& captured) {
    auto frame = slot();
    if (frame && !unpack(captured.bytes, stream_.agreed().stride, *frame)) {
        ++counters_.damaged;
        return std::nullopt;
    }
    if (frame) frame->setShared(invites_);
    return frame;
}

} // namespace autostereo::devices::v4l2

#include "devices/v4l2/v4l2_source.hpp"

#include "devices/v4l2/camera_controls.hpp"
#include "devices/v4l2/unpack.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace autostereo::devices::v4l2 {

namespace {

TimePoint now() { return std::chrono::steady_clock::now(); }

} // namespace

V4l2Source::V4l2Source(CaptureStream stream, double depthUnitM,
                       std::shared_ptr<Continuity> continuity)
    : stream_(std::move(stream)), format_(*knownFormat(stream_.agreed().mode.code)),
      depthUnitM_(depthUnitM), continuity_(std::move(continuity)),
      sequence_(continuity_->nextSequence) {
    continuity_->silence.start(now(), stream_.agreed().mode.period);
}

ReadResult V4l2Source::read(TimePoint deadline) noexcept try {
    // Damaged frames do not keep a caller longer than it wants.
    do {
        const TimePoint quietAt = continuity_->silence.deadline();
        const auto outcome = stream_.wait(std::min(deadline, quietAt));
        if (const auto* broken = std::get_if<CaptureStream::Broken>(&outcome))
            return Disconnected{stream_.node().path() + ": " + broken->reason};
        if (const auto* captured = std::get_if<Captured>(&outcome)) {
            auto frame = convert(*captured);
            stream_.giveBack(*captured);
            if (frame) return std::move(*frame);
        } else if (now() >= quietAt) {
            return silent();
        }
    } while (now() < deadline);
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
    const TimePoint time = now();
    lookAtExposure(time);
    continuity_->silence.frame(time, exposure_);
    const std::uint64_t sequence = sequence_.map(captured.sequence);
    continuity_->nextSequence = sequence + 1;
    if (captured.damaged) {
        ++counters_.damaged;
        return std::nullopt;
    }
    auto frame = format_.jpeg ? decode(captured) : copy(captured);
    if (!frame) return std::nullopt;
    frame->metadata().sequence = sequence;
    frame->metadata().capturedAt =
        clock_.midExposure(captured.stamp, captured.stampOf, exposure_, time);
    ++counters_.delivered;
    return frame;
}

std::optional<Frame> V4l2Source::slot(int width, int height, std::size_t encodedBytes) {
    FrameMetadata metadata;
    metadata.format = format_.pixels;
    metadata.width = width;
    metadata.height = height;
    metadata.depthUnitM = depthUnitM_;
    metadata.matrix = stream_.agreed().yuv.matrix;
    metadata.range = stream_.agreed().yuv.range;
    metadata.encodedBytes = encodedBytes;
    auto frame = pool_.acquire(metadata);
    if (!frame) ++counters_.starved;
    return frame;
}

std::optional<Frame> V4l2Source::decode(const Captured& captured) try {
    const Mode& mode = stream_.agreed().mode;
    const ImageHeader header = jpeg_.open(captured.bytes);
    if (header.size() != PictureSize{mode.width, mode.height}) {
        ++counters_.damaged;
        return std::nullopt;
    }
    auto frame = slot(mode.width, mode.height, captured.bytes.size());
    if (!frame) return std::nullopt;
    jpeg_.decode(frame->pixels());
    std::ranges::copy(captured.bytes, frame->encoded().begin());
    return frame;
} catch (const std::exception&) {
    ++counters_.damaged;
    return std::nullopt;
}

std::optional<Frame> V4l2Source::copy(const Captured& captured) {
    const Agreed& agreed = stream_.agreed();
    auto frame = slot(agreed.mode.width, agreed.mode.height);
    if (frame && !unpack(captured.bytes, agreed.stride, *frame)) {
        ++counters_.damaged;
        return std::nullopt;
    }
    return frame;
}

} // namespace autostereo::devices::v4l2

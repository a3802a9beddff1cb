#include "devices/replay/kinect_sources.hpp"

#include <algorithm>
#include <cstring>
#include <exception>
#include <utility>

namespace autostereo::devices {

namespace {

std::size_t pixelCount(PictureSize size) {
    return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

PixelFormat pixelFormat(KinectColorFormat format) {
    switch (format) {
    case KinectColorFormat::Nv12:
        return PixelFormat::Nv12;
    case KinectColorFormat::Yuy2:
        return PixelFormat::Yuyv;
    case KinectColorFormat::Bgra:
        return PixelFormat::Bgra8;
    case KinectColorFormat::Mjpg:
        break;
    }
    return PixelFormat::Rgba8; // as the decoder gives it
}

void fromBigEndian(std::span<const std::byte> from, std::span<std::uint16_t> to) {
    std::memcpy(to.data(), from.data(), to.size_bytes());
    for (std::uint16_t& value : to)
        value = static_cast<std::uint16_t>(value << 8U | value >> 8U);
}

/// Reads blocks until `convert` makes a frame of one. Whatever it throws is a damaged picture.
template<class Convert>
ReadResult readFrame(MatroskaBlocks& blocks, RecordedStream& stream, const Convert& convert) {
    for (;;) {
        try {
            const auto block = blocks.next();
            if (!block) return Ended{};
            if (auto frame = convert(*block)) return stream.deliver(std::move(*frame));
        } catch (const std::exception&) {
            stream.countDamaged();
        }
    }
}

SourceCounters total(const RecordedStream& stream, const MatroskaBlocks& blocks) {
    SourceCounters counters = stream.counters();
    counters.damaged += blocks.damaged();
    return counters;
}

} // namespace

KinectDepthSource::KinectDepthSource(const KinectTrack& depth,
                                     std::optional<unsigned> infraredTrack)
    : track_(depth), blocks_(depth.path, depth.info, depth.number),
      stream_(PixelFormat::Depth16, depth.size, depth.depthUnitM) {
    if (infraredTrack) infraredBlocks_.emplace(depth.path, depth.info, *infraredTrack);
}

bool KinectDepthSource::infraredReaches(Duration time) {
    if (!infraredBlocks_) return false;
    while (!infrared_ || infrared_->time < time) {
        infrared_ = infraredBlocks_->next();
        if (!infrared_) return false;
    }
    return infrared_->time == time && infrared_->payload.size() == 2 * pixelCount(track_.size);
}

std::optional<Frame> KinectDepthSource::convert(const MatroskaBlock& block) {
    const std::uint64_t sequence = sequence_++;
    if (block.payload.size() != 2 * pixelCount(track_.size)) {
        stream_.countDamaged();
        return std::nullopt;
    }
    const bool hasInfrared = infraredReaches(block.time);
    auto frame = stream_.slot(track_.size, sequence, TimePoint{block.time + track_.startOffset},
                              hasInfrared);
    if (!frame) return std::nullopt;
    fromBigEndian(block.payload, frame->depth());
    if (hasInfrared) fromBigEndian(infrared_->payload, frame->amplitude());
    return frame;
}

ReadResult KinectDepthSource::read(TimePoint /*deadline*/) noexcept {
    return readFrame(blocks_, stream_, [this](const MatroskaBlock& b) { return convert(b); });
}

bool KinectDepthSource::rewind() noexcept {
    blocks_.rewind();
    if (infraredBlocks_) infraredBlocks_->rewind();
    infrared_.reset();
    sequence_ = 0;
    return true;
}

SourceCounters KinectDepthSource::counters() const noexcept { return total(stream_, blocks_); }

KinectColorSource::KinectColorSource(const KinectTrack& color, KinectColorFormat format)
    : track_(color), format_(format), blocks_(color.path, color.info, color.number),
      stream_(pixelFormat(format), color.size) {}

std::optional<Frame> KinectColorSource::convertJpeg(const MatroskaBlock& block) {
    const std::uint64_t sequence = sequence_++;
    const ImageHeader header = jpeg_.open(block.payload);
    auto frame = stream_.slot(header.size(), sequence, TimePoint{block.time + track_.startOffset},
                              false, block.payload.size());
    if (!frame) return std::nullopt;
    jpeg_.decode(frame->pixels());
    std::ranges::copy(block.payload, frame->encoded().begin());
    return frame;
}

std::optional<Frame> KinectColorSource::convert(const MatroskaBlock& block) {
    if (format_ == KinectColorFormat::Mjpg) return convertJpeg(block);
    const std::uint64_t sequence = sequence_++;
    const auto [width, height] = track_.size;
    const PixelFormat format = pixelFormat(format_);
    if (!allowsSize(format, width, height) ||
        block.payload.size() != frameBytes(format, width, height)) {
        stream_.countDamaged();
        return std::nullopt;
    }
    auto frame = stream_.slot(track_.size, sequence, TimePoint{block.time + track_.startOffset});
    if (!frame) return std::nullopt;
    frame->metadata().matrix = YuvMatrix::Bt601; // as the Azure Kinect's own software reads them
    frame->metadata().range = YuvRange::Limited;
    std::ranges::copy(block.payload, frame->pixels().begin());
    return frame;
}

ReadResult KinectColorSource::read(TimePoint /*deadline*/) noexcept {
    return readFrame(blocks_, stream_, [this](const MatroskaBlock& b) { return convert(b); });
}

bool KinectColorSource::rewind() noexcept {
    blocks_.rewind();
    sequence_ = 0;
    return true;
}

SourceCounters KinectColorSource::counters() const noexcept { return total(stream_, blocks_); }

} // namespace autostereo::devices

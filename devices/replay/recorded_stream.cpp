#include "devices/replay/recorded_stream.hpp"

#include <utility>

namespace autostereo::devices {

RecordedStream::RecordedStream(PixelFormat format, PictureSize size, double depthUnitM)
    : format_(format), size_(size), depthUnitM_(depthUnitM) {}

std::optional<Frame> RecordedStream::slot(PictureSize size, std::uint64_t sequence,
                                          TimePoint capturedAt, bool amplitude,
                                          std::size_t encodedBytes) {
    if (size_ == PictureSize{}) size_ = size;
    if (size != size_) {
        ++counters_.damaged;
        return std::nullopt;
    }
    FrameMetadata metadata;
    metadata.format = format_;
    metadata.width = size.width;
    metadata.height = size.height;
    metadata.sequence = sequence;
    metadata.capturedAt = capturedAt;
    metadata.depthUnitM = depthUnitM_;
    metadata.hasAmplitude = amplitude;
    metadata.encodedBytes = encodedBytes;
    auto frame = pool_.acquire(metadata);
    if (!frame) ++counters_.starved;
    return frame;
}

ReadResult RecordedStream::deliver(Frame&& frame) {
    ++counters_.delivered;
    return std::move(frame);
}

} // namespace autostereo::devices

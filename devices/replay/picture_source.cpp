#include "devices/replay/picture_source.hpp"

#include <exception>
#include <utility>

namespace autostereo::devices {

PictureSource::PictureSource(std::vector<Picture> pictures, PixelFormat format, PictureSize size,
                             double depthUnitM)
    : pictures_(std::move(pictures)),
      wanted_(format == PixelFormat::Depth16 ? ImageFormat::Grey16 : ImageFormat::Rgba8),
      stream_(format, size, depthUnitM) {}

std::optional<Frame> PictureSource::load(std::size_t index) noexcept try {
    const Picture& picture = pictures_[index];
    const ImageHeader header = reader_.open(picture.path);
    if (header.format != wanted_) {
        stream_.countDamaged();
        return std::nullopt;
    }
    auto frame = stream_.slot(header.size(), index, picture.capturedAt);
    if (frame) reader_.decode(frame->pixels());
    return frame;
} catch (const std::exception&) {
    stream_.countDamaged();
    return std::nullopt;
}

ReadResult PictureSource::read(TimePoint /*deadline*/) noexcept {
    while (next_ < pictures_.size())
        if (auto frame = load(next_++)) return stream_.deliver(std::move(*frame));
    return Ended{};
}

bool PictureSource::rewind() noexcept {
    next_ = 0;
    return true;
}

SourceCounters PictureSource::counters() const noexcept { return stream_.counters(); }

} // namespace autostereo::devices

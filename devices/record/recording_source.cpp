#include "devices/record/recording_source.hpp"

#include <utility>

namespace autostereo::devices {

RecordingSource::RecordingSource(std::unique_ptr<Source> source, std::shared_ptr<PictureTap> tap,
                                 RecordedStream stream)
    : source_(std::move(source)), tap_(std::move(tap)), stream_(stream) {}

ReadResult RecordingSource::read(TimePoint deadline) noexcept {
    ReadResult result = source_->read(deadline);
    if (const auto* frame = std::get_if<Frame>(&result); frame != nullptr && !rewound_)
        tap_->offer(stream_, *frame);
    return result;
}

bool RecordingSource::rewind() noexcept {
    rewound_ = true;
    return source_->rewind();
}

Input recorded(Input input, const std::shared_ptr<PictureTap>& tap) {
    const auto wrap = [&](std::unique_ptr<Source>& source, Reopen& reopen, RecordedStream stream) {
        if (source) source = std::make_unique<RecordingSource>(std::move(source), tap, stream);
        if (!reopen) return;
        reopen = [again = std::move(reopen), tap, stream] {
            return std::make_unique<RecordingSource>(again(), tap, stream);
        };
    };
    wrap(input.depth, input.reopen.depth, RecordedStream::Depth);
    wrap(input.color, input.reopen.color, RecordedStream::Color);
    return input;
}

} // namespace autostereo::devices

#include "devices/record/recording_source.hpp"

#include <utility>

namespace autostereo::devices {

RecordingSource::RecordingSource(std::unique_ptr<Source> source, std::shared_ptr<Recorder> recorder,
                                 Recorder::Stream stream)
    : source_(std::move(source)), recorder_(std::move(recorder)), stream_(stream) {}

ReadResult RecordingSource::read(TimePoint deadline) noexcept {
    ReadResult result = source_->read(deadline);
    if (const auto* frame = std::get_if<Frame>(&result); frame != nullptr && !rewound_)
        recorder_->offer(stream_, *frame);
    return result;
}

bool RecordingSource::rewind() noexcept {
    rewound_ = true;
    return source_->rewind();
}

Input recorded(Input input, const std::shared_ptr<Recorder>& recorder) {
    const auto wrap = [&](std::unique_ptr<Source>& source, Reopen& reopen,
                          Recorder::Stream stream) {
        if (source) source = std::make_unique<RecordingSource>(std::move(source), recorder, stream);
        if (!reopen) return;
        reopen = [again = std::move(reopen), recorder, stream] {
            return std::make_unique<RecordingSource>(again(), recorder, stream);
        };
    };
    wrap(input.depth, input.reopen.depth, Recorder::Stream::Depth);
    wrap(input.color, input.reopen.color, Recorder::Stream::Color);
    return input;
}

} // namespace autostereo::devices

#pragma once

#include "devices/record/recorder.hpp"
#include "devices/source.hpp"

#include <memory>

namespace autostereo::devices {

/// A source whose frames are recorded on their way. What comes after a rewind is not: it has been
/// recorded. Thread-bound.
class RecordingSource final : public Source {
  public:
    RecordingSource(std::unique_ptr<Source> source, std::shared_ptr<PictureTap> tap,
                    RecordedStream stream);
    [[nodiscard]] ReadResult read(TimePoint deadline) noexcept override;
    [[nodiscard]] bool rewind() noexcept override;
    [[nodiscard]] SourceCounters counters() const noexcept override { return source_->counters(); }

  private:
    std::unique_ptr<Source> source_;
    std::shared_ptr<PictureTap> tap_;
    RecordedStream stream_;
    bool rewound_ = false;
};

/// The same input with both of its streams recorded.
[[nodiscard]] Input recorded(Input input, const std::shared_ptr<PictureTap>& tap);

} // namespace autostereo::devices

#pragma once

#include "devices/params.hpp"
#include "devices/record/recorded_picture.hpp"

#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <vector>

namespace autostereo::devices {

/// The last pictures of two streams, in memory and nowhere else: those of `length`, fewer where
/// that would take more than `mostBytes`. Thread-safe.
class RecordingRing final : public PictureTap {
  public:
    using Pictures = std::vector<std::shared_ptr<const RecordedPicture>>;
    struct Held {
        RecordingHead head;
        Pictures pictures; ///< by time
    };

    explicit RecordingRing(const RingParams& params) : params_(params) {}

    /// Of other cameras from now on; what was held is gone.
    void begin(RecordingHead head);
    void offer(RecordedStream stream, const Frame& frame) override;
    [[nodiscard]] Held held() const;

  private:
    RingParams params_;
    mutable std::mutex mutex_; ///< of what follows
    RecordingHead head_;
    std::deque<std::shared_ptr<const RecordedPicture>> pictures_; ///< as they came
    std::size_t bytes_ = 0;
};

/// As a recording of the same convention as Recorder's. Throws RecordingError.
void writeRecording(const RecordingRing::Held& held, const std::filesystem::path& file);
/// The same, as the file's bytes. Throws RecordingError.
[[nodiscard]] std::vector<std::uint8_t> recordingOf(const RecordingRing::Held& held);

} // namespace autostereo::devices

#pragma once

#include "devices/record/recorded_picture.hpp"

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace autostereo::devices {

/// Writes what two streams deliver to a Matroska file in the Azure Kinect convention (tracks COLOR,
/// DEPTH, IR; calibration attached), in order of time, on a thread of its own. Whoever offers
/// frames never waits for the disk, unless asked to: what does not fit into `mostBytes` is left out
/// and counted. Where the disk refuses, the recording ends there, playable, and says so once.
class Recorder final : public PictureTap {
  public:
    using Stream = RecordedStream;
    enum class WhenBehind : std::uint8_t { LeaveOut, Wait };
    struct Counters {
        std::uint64_t written = 0, leftOut = 0, bytes = 0; ///< pictures; of the file
        std::string error;                                 ///< why it ended; "": it goes on
    };
    using Picture = RecordedPicture;
    static constexpr std::size_t kMostBytes = 256U << 20U;

    /// Both throw RecordingError.
    Recorder(const std::filesystem::path& file, const Input& input, WhenBehind whenBehind,
             std::size_t mostBytes = kMostBytes)
        : Recorder(file, headOf(input), whenBehind, mostBytes) {}
    Recorder(const std::filesystem::path& file, RecordingHead head, WhenBehind whenBehind,
             std::size_t mostBytes = kMostBytes);
    /// Writes what it still holds.
    ~Recorder() override;
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// Writes what it still holds and closes the file; nothing more is taken.
    void finish();
    /// Copies the picture. Any thread, a stream always the same one.
    void offer(Stream stream, const Frame& frame) override { offer(copyOf(stream, frame)); }
    void offer(Picture picture);
    [[nodiscard]] Counters counters() const;

  private:
    void run(const std::stop_token& stop);
    /// The next to write, or nothing while an earlier one may still come.
    [[nodiscard]] std::optional<Picture> takeDue(bool all);
    void write(Picture picture);
    void begin(const Picture& first);
    void end(const std::string& error);
    [[nodiscard]] bool append(const char* track, const FrameMetadata& form,
                              std::span<const std::byte> payload);

    std::filesystem::path file_;
    WhenBehind whenBehind_;
    std::size_t mostBytes_;
    RecordingHead head_;

    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::multimap<TimePoint, Picture> waiting_; ///< by time of capture
    std::map<Stream, TimePoint> newest_;        ///< of each stream so far
    std::map<Stream, FrameMetadata> forms_;     ///< of its first picture
    std::size_t waitingBytes_ = 0;
    bool isFull_ = false; ///< somebody waits for room
    Counters counters_;

    // Of the thread alone.
    std::unique_ptr<MatroskaWriter> writer_;
    std::map<std::string, unsigned> tracks_; ///< name -> number
    TimePoint startedAt_{};
    std::jthread thread_; // last: ends before what it uses
};

} // namespace autostereo::devices

#pragma once

#include "devices/clock.hpp"
#include "devices/unique_fd.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace autostereo::devices {

/// What a recording is to be like; in the Azure Kinect convention.
struct RecordingTrack {
    std::string name;   ///< COLOR, DEPTH, IR
    std::string fourCc; ///< MJPG, NV12, YUY2, BGRA, b16g
    int width = 0;
    int height = 0;
    int bitsPerPixel = 0;
    Duration period{0};                                      ///< between frames, 0: unknown
    std::vector<std::pair<std::string, std::string>> tags{}; ///< of this track
};
struct RecordingAttachment {
    std::string name, tag; ///< file name; tag that points at it
    std::vector<std::byte> data;
};
struct RecordingLayout {
    std::vector<RecordingTrack> tracks; ///< numbered from 1
    std::vector<RecordingAttachment> attachments;
    std::vector<std::pair<std::string, std::string>> tags; ///< of the whole file
};

/// The disk is full, gone, or refuses; one line.
class RecordingError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A Matroska file that can be played at any moment, also when the program is killed: the segment's
/// size stays unknown until `finish`, and a picture is one cluster, in the file when `write`
/// returns. Thread-bound; everything may throw RecordingError.
class MatroskaWriter {
  public:
    /// Replaces the file.
    MatroskaWriter(const std::filesystem::path& path, const RecordingLayout& layout);
    ~MatroskaWriter();
    MatroskaWriter(const MatroskaWriter&) = delete;
    MatroskaWriter& operator=(const MatroskaWriter&) = delete;

    /// `track` from 1, `time` since the recording's start, never less than the one before.
    void write(unsigned track, Duration time, std::span<const std::byte> payload);
    /// Index, duration and size. Nothing may be written after.
    void finish();
    [[nodiscard]] std::uint64_t bytes() const { return position_; }

  private:
    struct Cue {
        std::uint64_t ticks;
        unsigned track;
        std::uint64_t position; ///< of the cluster in the segment
    };
    void writeHead(const RecordingLayout& layout);
    void append(std::span<const std::byte> first, std::span<const std::byte> second = {});
    void patch(std::uint64_t at, std::span<const std::byte> bytes);
    [[noreturn]] void fail(int cause) const;

    std::filesystem::path path_;
    UniqueFd fd_;
    std::uint64_t position_ = 0;
    std::uint64_t segmentBegin_ = 0, durationAt_ = 0;
    std::uint64_t lastTicks_ = 0;
    std::vector<Cue> cues_;
};

} // namespace autostereo::devices

#pragma once

#include "devices/kinect2/raw/raw_record.hpp"
#include "devices/kinect2/raw/raw_tap.hpp"
#include "devices/record/raw_recording.hpp"
#include "devices/unique_fd.hpp"

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace autostereo::devices::kinect2 {

/// Writes what a unit sends to a file (see raw_record.hpp), on a thread of its own. Whoever offers
/// packets never waits for the disk: what does not fit into `mostBytes` is left out and counted,
/// and the streams are marked as damaged there. Where the disk refuses, the recording ends,
/// playable, and says so once. Thread-safe.
class RawRecorder final : public RawTap, public RawRecording {
  public:
    static constexpr std::size_t kMostBytes = std::size_t{256} << 20U;

    /// Replaces the file. Throws RecordingError.
    explicit RawRecorder(std::filesystem::path file, std::size_t mostBytes = kMostBytes);
    ~RawRecorder() override;

    void start(const UnitPages& pages, TimePoint time) override;
    void depth(std::span<const std::byte> packet, bool intact, TimePoint arrived) override;
    void color(std::span<const std::byte> packet, bool intact, TimePoint arrived) override;
    void finish() override;
    [[nodiscard]] Counters counters() const override;

  private:
    /// Whole records, their checksums still to be filled in.
    using Chunk = std::vector<std::byte>;

    // Under mutex_. False: there is no room.
    [[nodiscard]] bool hasRoom(std::size_t bytes) const;
    [[nodiscard]] bool add(RawKind kind, std::span<const std::byte> payload, bool intact,
                           TimePoint arrived);
    [[nodiscard]] bool addStart();
    void addPacket(RawKind kind, std::span<const std::byte> packet, bool intact, TimePoint arrived);
    [[nodiscard]] Chunk emptyChunk();
    void run(const std::stop_token& stop);
    [[nodiscard]] bool write(Chunk& chunk);
    void end(int cause);

    std::filesystem::path path_;
    std::size_t mostBytes_;
    UniqueFd file_;

    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Chunk> waiting_; ///< the last one may grow
    std::vector<Chunk> used_;   ///< written, their memory serves again
    std::size_t waitingBytes_ = 0;
    std::optional<UnitPages> pages_; ///< of a start that is not in the file yet
    TimePoint startedAt_{};
    bool full_ = false;           ///< packets are being left out
    bool lastDepthEmpty_ = false; ///< and intact
    Counters counters_;
    std::jthread thread_; // last: it uses all of the above
};

} // namespace autostereo::devices::kinect2

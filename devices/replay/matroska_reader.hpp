#pragma once

#include "devices/clock.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace autostereo::devices {

struct MatroskaTrack {
    unsigned number = 0;
    std::string name;
    std::string codec;
    std::vector<std::byte> codecPrivate;
    int width = 0; ///< pixels, 0: not a video track or out of range
    int height = 0;
    Duration period{0};   ///< between frames, 0: unknown
    bool encoded = false; ///< its blocks are compressed or encrypted on top of the codec
};

/// Everything in a Matroska file but its clusters. Damaged parts are left out.
struct MatroskaInfo {
    std::vector<MatroskaTrack> tracks;
    std::map<std::string, std::string> tags;
    std::map<std::string, std::vector<std::byte>> attachments; ///< by file name
    std::uint64_t timecodeScale = 1'000'000;                   ///< nanoseconds per tick
    std::uint64_t firstCluster = 0;                            ///< where the blocks begin, in bytes
};

/// Throws DeviceError where `path` cannot be opened or is no Matroska file.
[[nodiscard]] MatroskaInfo readMatroskaInfo(const std::filesystem::path& path);

struct MatroskaBlock {
    Duration time{0};                   ///< media time
    std::span<const std::byte> payload; ///< valid until the next call
};

/// The blocks of one track, in file order. Opens the file for itself. Sizes are checked before
/// anything is allocated; damage is counted and reading goes on at the next cluster, always
/// forwards, so that every file ends. Laced blocks count as damaged. Thread-bound; opening throws
/// DeviceError, reading does not throw but std::bad_alloc.
class MatroskaBlocks {
  public:
    MatroskaBlocks(const std::filesystem::path& path, const MatroskaInfo& info, unsigned track);
    ~MatroskaBlocks();
    MatroskaBlocks(const MatroskaBlocks&) = delete;
    MatroskaBlocks& operator=(const MatroskaBlocks&) = delete;

    [[nodiscard]] std::optional<MatroskaBlock> next();
    void rewind();
    [[nodiscard]] std::uint64_t damaged() const;

  private:
    class Reader;
    std::unique_ptr<Reader> reader_;
};

} // namespace autostereo::devices

#pragma once

#include "devices/replay/image_files.hpp"
#include "devices/replay/recorded_stream.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace autostereo::devices {

/// One file of a stream and its media time.
struct Picture {
    std::filesystem::path path;
    TimePoint capturedAt{};
};

/// Plays a list of picture files, in order, without waiting. Depth must be 16-bit grey, colour
/// anything with 8 bits. Unreadable files are dropped and counted. Thread-bound.
class PictureSource final : public Source {
  public:
    PictureSource(std::vector<Picture> pictures, PixelFormat format, PictureSize size,
                  double depthUnitM);
    [[nodiscard]] ReadResult read(TimePoint deadline) noexcept override;
    [[nodiscard]] bool rewind() noexcept override;
    [[nodiscard]] SourceCounters counters() const noexcept override;

  private:
    [[nodiscard]] std::optional<Frame> load(std::size_t index) noexcept;

    std::vector<Picture> pictures_;
    ImageFormat wanted_;
    RecordedStream stream_;
    ImageReader reader_;
    std::size_t next_ = 0;
};

} // namespace autostereo::devices

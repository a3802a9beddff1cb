#pragma once

#include "devices/replay/jpeg_decoder.hpp"
#include "devices/replay/matroska_reader.hpp"
#include "devices/replay/recorded_stream.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace autostereo::devices {

/// One track of a recording: where its blocks are and what they hold.
struct KinectTrack {
    std::filesystem::path path;
    MatroskaInfo info;
    unsigned number = 0;
    PictureSize size;
    Duration startOffset{0}; ///< added to every block's time
    double depthUnitM = 0.001;
};

/// Depth (b16g: big-endian uint16, millimetres), with the IR picture of the same time as amplitude
/// where the recording has one. Plays without waiting; damaged blocks are counted. Thread-bound.
class KinectDepthSource final : public Source {
  public:
    KinectDepthSource(const KinectTrack& depth, std::optional<unsigned> infraredTrack);
    [[nodiscard]] ReadResult read(TimePoint deadline) noexcept override;
    [[nodiscard]] bool rewind() noexcept override;
    [[nodiscard]] SourceCounters counters() const noexcept override;

  private:
    [[nodiscard]] std::optional<Frame> convert(const MatroskaBlock& block);
    [[nodiscard]] bool infraredReaches(Duration time);

    KinectTrack track_;
    MatroskaBlocks blocks_;
    std::optional<MatroskaBlocks> infraredBlocks_;
    std::optional<MatroskaBlock> infrared_; ///< the next one not yet used
    RecordedStream stream_;
    std::uint64_t sequence_ = 0;
};

enum class KinectColorFormat : std::uint8_t { Mjpg, Nv12, Yuy2, Bgra };

/// Colour, as it is recorded; JPEG decoded to Rgba8. Plays without waiting; damaged blocks are
/// counted. Thread-bound.
class KinectColorSource final : public Source {
  public:
    KinectColorSource(const KinectTrack& color, KinectColorFormat format);
    [[nodiscard]] ReadResult read(TimePoint deadline) noexcept override;
    [[nodiscard]] bool rewind() noexcept override;
    [[nodiscard]] SourceCounters counters() const noexcept override;

  private:
    [[nodiscard]] std::optional<Frame> convert(const MatroskaBlock& block);
    [[nodiscard]] std::optional<Frame> convertJpeg(const MatroskaBlock& block);

    KinectTrack track_;
    KinectColorFormat format_;
    MatroskaBlocks blocks_;
    JpegDecoder jpeg_;
    RecordedStream stream_;
    std::uint64_t sequence_ = 0;
};

} // namespace autostereo::devices

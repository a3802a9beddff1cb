#pragma once

#include "devices/frame.hpp"
#include "devices/input.hpp"
#include "devices/record/matroska_writer.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace autostereo::devices {

enum class RecordedStream : std::uint8_t { Depth, Color };

/// A frame's bytes, copied as they lie in it.
struct RecordedPicture {
    RecordedStream stream;
    FrameMetadata form;
    std::vector<std::byte> sent, infrared;
    [[nodiscard]] std::size_t bytes() const { return sent.size() + infrared.size(); }
};
[[nodiscard]] RecordedPicture copyOf(RecordedStream stream, const Frame& frame);

/// What a recording says of its cameras.
struct RecordingHead {
    std::vector<RecordingAttachment> attachments;
    Duration period{0};
    std::size_t streams = 0;
};
[[nodiscard]] RecordingHead headOf(const Input& input);

/// Is shown every frame of two streams, on the sensors' threads; each stream always on the same
/// one.
class PictureTap {
  public:
    virtual ~PictureTap() = default;
    virtual void offer(RecordedStream stream, const Frame& frame) = 0;
};

} // namespace autostereo::devices

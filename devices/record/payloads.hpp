#pragma once

#include "devices/frame.hpp"
#include "devices/record/matroska_writer.hpp"

#include <vector>

namespace autostereo::devices {

/// How a stream's pictures are kept: what the camera sent as it sent it where the convention knows
/// it (JPEG, NV12, YUYV, BGRA), everything else as BGRA, which loses nothing. `first`: its first
/// picture. Reentrant.
[[nodiscard]] RecordingTrack colorTrack(const FrameMetadata& first, Duration period);
[[nodiscard]] RecordingTrack depthTrack(const FrameMetadata& first, Duration period);
[[nodiscard]] RecordingTrack infraredTrack(const FrameMetadata& first, Duration period);

/// What a block is made of, as it lies in the frame: its JPEG where it has one, else its pixels.
[[nodiscard]] std::span<const std::byte> sentBytes(const Frame& frame);
/// Those bytes as the block keeps them: JPEGs the right way round (throws std::runtime_error where
/// that cannot be), counts and amplitudes big-endian (b16g).
[[nodiscard]] std::vector<std::byte> colorPayload(const FrameMetadata& form,
                                                  std::vector<std::byte> bytes);
[[nodiscard]] std::vector<std::byte> countsPayload(std::vector<std::byte> bytes);

} // namespace autostereo::devices

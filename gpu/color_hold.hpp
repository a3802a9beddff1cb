#pragma once

#include "devices/frame.hpp"
#include "gpu/params.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace autostereo::gpu {

/// A camera's bytes -> the same, but blocks of 8 x 8 pixels that differ from what was kept by noise
/// only stay as they were kept, byte for byte, so that a still scene is a still picture. A block is
/// renewed as a whole as soon as a byte, a channel's mean or the mean square is off by more than
/// noise can explain: what slowly fades is never off by more. On the host, because a frame is there
/// and what is kept need not even be uploaded. Thread-bound.
class ColorHold {
  public:
    explicit ColorHold(const ColorHoldParams& params) : params_(params) {}

    /// Takes a frame in. True where any block was renewed; another size or format renews all.
    [[nodiscard]] bool update(const devices::Frame& frame);
    /// The next frame renews all.
    void forget() { kept_.clear(); }
    /// As the camera gave them.
    [[nodiscard]] std::span<const std::byte> bytes() const { return kept_; }
    /// A byte a block of the picture, row by row; not 0: renewed by the last frame.
    [[nodiscard]] const std::vector<std::uint8_t>& renewed() const { return renewed_; }
    /// Blocks kept and seen so far.
    [[nodiscard]] std::uint64_t blocksKept() const { return blocksKept_; }
    [[nodiscard]] std::uint64_t blocksSeen() const { return blocksSeen_; }

  private:
    struct Plane;
    void restart(const devices::Frame& frame);
    bool updatePlane(const Plane& plane, std::span<const std::byte> pixels);
    [[nodiscard]] bool isNoise(std::size_t left, std::size_t bytes, std::size_t period,
                               std::size_t rows) const;
    void judgeRow(const std::byte* now, const std::byte* kept, std::size_t bytes);

    ColorHoldParams params_;
    devices::FrameMetadata form_;
    std::vector<std::byte> kept_;
    std::vector<std::uint8_t> renewed_;
    std::vector<std::int16_t> sums_;     ///< of differences in eight rows, a column of bytes each
    std::vector<std::uint32_t> squares_; ///< the same
    std::vector<std::uint8_t> worst_;    ///< the same, largest
    std::uint64_t blocksKept_ = 0, blocksSeen_ = 0;
};

} // namespace autostereo::gpu

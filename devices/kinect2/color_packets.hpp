#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace autostereo::devices::kinect2 {

/// One picture of the colour camera.
struct ColorPacket {
    std::span<const std::byte> jpeg; ///< 1920x1080; padding may follow its end
    std::uint32_t sequence = 0;
    std::uint32_t timestamp = 0; ///< device clock, units of 0.125 ms, wraps
    float exposureMs = 0;
    float digitalGain = 0;
    float analogGain = 0;
};

/// Takes a packet apart: header, JPEG, filler, footer. Nothing where its marks, size or the two
/// sequence numbers do not agree. Takes any bytes; the result points into them. Reentrant.
[[nodiscard]] std::optional<ColorPacket> parseColorPacket(std::span<const std::byte> packet);

/// Puts bulk transfers together until a footer ends them. What is damaged is dropped and counted;
/// memory is bounded. Thread-bound.
class ColorPackets {
  public:
    struct Counters {
        std::uint64_t pictures = 0;
        std::uint64_t broken = 0;
    };
    static constexpr std::size_t kMostBytes = std::size_t{4} << 20; // far above any 1080p JPEG

    /// The picture that these bytes complete, valid until the next call.
    [[nodiscard]] std::optional<ColorPacket> append(std::span<const std::byte> transfer);
    /// Forgets what is half read, as after a lost transfer.
    void reset();
    [[nodiscard]] const Counters& counters() const { return counters_; }

  private:
    std::vector<std::byte> bytes_;
    bool complete_ = false; ///< bytes_ was handed out
    Counters counters_;
};

} // namespace autostereo::devices::kinect2

#pragma once

#include "gpu/gl/objects.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace autostereo::gpu::gl {

/// Counters that shaders add to (a storage buffer of uint), read when the GPU is done with them:
/// some frames late, and a frame goes uncounted rather than waiting for one. Thread-bound.
class CounterRing {
  public:
    explicit CounterRing(std::size_t counters);
    ~CounterRing();
    CounterRing(const CounterRing&) = delete;
    CounterRing& operator=(const CounterRing&) = delete;

    /// Binds zeroed counters.
    void begin(GLuint binding);
    void end();
    /// Those of the oldest frame that was not yet taken, if they have arrived.
    [[nodiscard]] std::optional<std::vector<std::uint32_t>> take();
    /// Frames counted and not yet taken.
    [[nodiscard]] std::size_t pending() const { return pending_; }
    /// Those of the oldest of them, waited for. Needs one pending.
    [[nodiscard]] std::vector<std::uint32_t> waitForOldest();
    /// Those that were not yet taken never will be.
    void forget();

  private:
    [[nodiscard]] std::size_t oldest() const { return (next_ + kInFlight - pending_) % kInFlight; }
    [[nodiscard]] std::vector<std::uint32_t> readOldest();

    static constexpr std::size_t kInFlight = 4;
    std::size_t counters_;
    std::array<Buffer, kInFlight> buffers_;
    std::array<GLsync, kInFlight> fences_{};
    Buffer uncounted_;
    std::size_t next_ = 0;    ///< buffer to count into
    std::size_t pending_ = 0; ///< fenced and not yet taken
    bool counting_ = false;
};

} // namespace autostereo::gpu::gl

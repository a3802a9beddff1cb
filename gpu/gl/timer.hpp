#pragma once

#include "gpu/gl/objects.hpp"

#include <array>
#include <optional>

namespace autostereo::gpu::gl {

/// GPU time of one stage by delayed queries: a result is picked up some frames later, and a frame
/// goes unmeasured rather than waiting for one. Thread-bound. Stages must not nest.
class Timer {
  public:
    Timer();
    void begin();
    /// Ends the measurement; gives the newest result that has arrived, in milliseconds.
    [[nodiscard]] std::optional<double> end();

  private:
    static constexpr std::size_t kInFlight = 4;
    std::array<Query, kInFlight> queries_;
    std::size_t next_ = 0;    ///< query to start
    std::size_t pending_ = 0; ///< started and not yet read
    bool measuring_ = false;
    bool first_ = true; ///< llvmpipe's very first result can be nonsense
};

} // namespace autostereo::gpu::gl

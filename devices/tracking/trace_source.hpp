#pragma once

#include "devices/tracking/eye_source.hpp"
#include "devices/tracking/eye_trace.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace autostereo::devices {

/// A recorded viewer (eye_trace.hpp), once: after its last sample the viewer is lost. Thread-bound.
class TraceSource final : public EyeSource {
  public:
    /// The trace's zero is at `start`.
    TraceSource(std::vector<TracedEyes> trace, TimePoint start)
        : trace_(std::move(trace)), start_(start) {}
    [[nodiscard]] std::optional<EyeSample> next(TimePoint now) override;
    [[nodiscard]] bool isLive() const noexcept override { return false; }
    [[nodiscard]] EyeCounters counters() const noexcept override { return {next_, next_, 0, 0}; }

  private:
    std::vector<TracedEyes> trace_;
    TimePoint start_;
    std::size_t next_ = 0;
};

} // namespace autostereo::devices

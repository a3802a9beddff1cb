#pragma once

#include "devices/sim/simulated_camera.hpp"
#include "devices/source.hpp"

#include <filesystem>
#include <memory>

namespace autostereo::devices::sim {

/// A simulated stream that behaves like a camera on a cable: live, on the host's clock, and there
/// only while a file is. Without the file it is disconnected; while that holds the word "silent" no
/// frame comes. Both cameras of an input expose at the same multiples of their period.
/// Thread-bound.
class PluggedSource final : public Source {
  public:
    /// Throws DeviceError where the file is not there. `offset` as FrameTiming's.
    PluggedSource(std::filesystem::path plug, std::unique_ptr<Source> source, Duration period,
                  Duration offset, Clock& clock);

    [[nodiscard]] ReadResult read(TimePoint deadline) noexcept override;
    [[nodiscard]] bool rewind() noexcept override { return false; }
    [[nodiscard]] SourceCounters counters() const noexcept override { return source_->counters(); }

  private:
    std::filesystem::path plug_;
    std::unique_ptr<Source> source_;
    Duration period_;
    Duration offset_;
    Clock& clock_;
    TimePoint next_; ///< middle of the next exposure
};

} // namespace autostereo::devices::sim

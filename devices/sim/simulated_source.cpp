#include "devices/sim/simulated_source.hpp"

#include <cmath>
#include <utility>

namespace autostereo::devices::sim {

TimePoint FrameTiming::at(std::uint64_t frame) const {
    const double nanoseconds = std::round(static_cast<double>(frame) * 1e9 / fps);
    return TimePoint(Duration(static_cast<Duration::rep>(nanoseconds)) + offset);
}

SimulatedSource::SimulatedSource(std::unique_ptr<SimulatedCamera> camera, const FrameTiming& timing)
    : camera_(std::move(camera)), timing_(timing) {}

ReadResult SimulatedSource::read(TimePoint) noexcept {
    if (timing_.frames && next_ >= *timing_.frames) return Ended{};
    FrameMetadata metadata = camera_->shape();
    metadata.sequence = next_;
    metadata.capturedAt = timing_.at(next_);
    ++next_;
    std::optional<Frame> frame = pool_.acquire(metadata);
    if (!frame) {
        ++counters_.starved;
        return Timeout{};
    }
    camera_->expose(*frame);
    frame->metadata().capturedAt += timing_.stampedLate;
    ++counters_.delivered;
    return std::move(*frame);
}

bool SimulatedSource::rewind() noexcept {
    next_ = 0;
    return true;
}

} // namespace autostereo::devices::sim

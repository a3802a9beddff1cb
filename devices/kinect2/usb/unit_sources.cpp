#include "devices/kinect2/usb/unit_sources.hpp"

#include <chrono>
#include <exception>
#include <utility>

namespace autostereo::devices::kinect2 {

namespace {

/// What either source does until `deadline`; `frames` makes one of what was taken, or counts.
template<class T, class Frames>
ReadResult readFrom(Unit& unit, Latest<T>& latest, T& raw, TimePoint deadline, Frames& frames) try {
    do {
        if (latest.take(raw, deadline)) {
            if (auto frame = frames.convert(raw)) return std::move(*frame);
        } else if (unit.lost()) {
            return Disconnected{unit.whyLost()};
        }
    } while (steadyNow() < deadline);
    return Timeout{};
} catch (const std::exception& error) {
    return Disconnected{std::string("kinect2: ") + error.what()};
}

} // namespace

DepthSource::DepthSource(std::shared_ptr<Unit> unit, std::shared_ptr<UnitContinuity> continuity)
    : unit_(std::move(unit)), frames_(std::move(continuity), unit_->facts()) {}

ReadResult DepthSource::read(TimePoint deadline) noexcept {
    return readFrom(*unit_, unit_->depth(), raw_, deadline, frames_);
}

SourceCounters DepthSource::counters() const noexcept {
    SourceCounters all = frames_.counters();
    all.damaged += unit_->counters().depth.brokenFrames;
    all.starved += unit_->depth().overwritten();
    return all;
}

ColorSource::ColorSource(std::shared_ptr<Unit> unit, std::shared_ptr<UnitContinuity> continuity)
    : unit_(std::move(unit)), frames_(std::move(continuity)) {}

ReadResult ColorSource::read(TimePoint deadline) noexcept {
    return readFrom(*unit_, unit_->color(), raw_, deadline, frames_);
}

SourceCounters ColorSource::counters() const noexcept {
    SourceCounters all = frames_.counters();
    all.damaged += unit_->counters().color.broken;
    all.starved += unit_->color().overwritten();
    return all;
}

} // namespace autostereo::devices::kinect2

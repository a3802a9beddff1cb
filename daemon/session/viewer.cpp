#include "daemon/session/viewer.hpp"

#include "devices/tracking/open_eyes.hpp"
#include "gpu/views/eye_synthesis.hpp"

#include <spdlog/spdlog.h>

namespace autostereo::daemon {

namespace {

/// More samples than any tracker sends between two pictures.
constexpr int kMostAtOnce = 10'000;

calib::EyePair eyesInTheMiddle(const calib::DisplayProfile& display, double spacingM) {
    const glm::dvec3 middle{0, 0, display.viewingDistanceM}, half{spacingM / 2, 0, 0};
    return {middle - half, middle + half};
}

} // namespace

std::unique_ptr<Viewer> Viewer::open(const devices::ViewerParams& params,
                                     const calib::DisplayProfile& display,
                                     std::optional<devices::TimePoint> start,
                                     devices::Clock& clock) {
    if (params.source.empty()) return nullptr;
    if (!gpu::EyeSynthesis::fits(display)) {
        spdlog::warn("viewer: {} is not used: display {} shows the same to every eye",
                     params.source, display.name);
        return nullptr;
    }
    return std::unique_ptr<Viewer>(new Viewer(params, display, start, clock));
}

Viewer::Viewer(const devices::ViewerParams& params, const calib::DisplayProfile& display,
               std::optional<devices::TimePoint> start, devices::Clock& clock)
    : sourceName_(params.source), eyes_(eyesInTheMiddle(display, params.spacingM)),
      source_(devices::openEyes(params, eyes_.middle(), start.value_or(devices::TimePoint{}),
                                !start, clock)),
      follower_(params, eyes_) {
    spdlog::info("viewer: {}", params.source);
}

const calib::EyePair& Viewer::eyes(devices::TimePoint now) {
    for (int i = 0; i < kMostAtOnce; ++i) {
        const auto sample = source_->next(now);
        if (!sample) break;
        follower_.add(*sample);
    }
    eyes_ = follower_.eyes(now);
    return eyes_;
}

ViewerStatus Viewer::status(devices::TimePoint now) const {
    return {sourceName_,         follower_.isTracked(now), follower_.lastSample(),
            source_->counters(), follower_.disordered(),   eyes_};
}

} // namespace autostereo::daemon

#include "devices/tracking/face_tracker.hpp"

#include "devices/replay/grey_image.hpp"
#include "devices/tracking/eye_place.hpp"

#include <algorithm>

namespace autostereo::devices {

namespace {

/// Looking everywhere costs some 50 ms of 640x480.
constexpr Duration kPatience = std::chrono::seconds(1), kRest = std::chrono::milliseconds(200);

void count(std::atomic<std::uint64_t>& counter) { counter.fetch_add(1, std::memory_order_relaxed); }

} // namespace

FaceTracker::FaceTracker(const ViewerParams& params) : params_(params) {}

EyeCounters FaceTracker::counters() const noexcept {
    return {received_.load(), accepted_.load(), damaged_.load(), limited_.load(), nobody_.load()};
}

void FaceTracker::leaveOut() {
    count(received_);
    count(limited_);
}

bool FaceTracker::rests(TimePoint now) const {
    return seenAt_ && searchedAt_ && now - *seenAt_ > kPatience && now >= *searchedAt_ &&
           now - *searchedAt_ < kRest;
}

void FaceTracker::track(const Frame& color, const Frame& depth, const calib::SensorRig& rig) {
    const TimePoint at = color.metadata().capturedAt;
    if (rests(at)) return leaveOut();
    count(received_);
    searchedAt_ = at;
    if (!seenAt_) seenAt_ = at;
    const auto seen = eyes(color, depth, rig);
    if (!seen) return count(nobody_);
    seenAt_ = at;
    const calib::EyePair there = inDisplaySpace(*seen, params_.pose);
    if (!isPlausible(there)) return count(damaged_);
    count(accepted_);
    queue_.push({at, there});
}

std::optional<calib::EyePair> FaceTracker::eyes(const Frame& color, const Frame& depth,
                                                const calib::SensorRig& rig) {
    const GreyPixels picture = greyOf(color);
    if (picture.values.empty()) return std::nullopt;
    grey_.resize(picture.values.size());
    std::ranges::transform(picture.values, grey_.begin(),
                           [](std::uint16_t value) { return static_cast<std::uint8_t>(value); });
    const auto pupils = finder_.find({grey_, picture.width, picture.height});
    if (!pupils) return std::nullopt;
    const auto found =
        eyesBySpacing(rig.color.resized(picture.width, picture.height), *pupils, params_.spacingM);
    if (!found || depth.empty()) return found;
    const auto measured = measuredDepth(depth, rig, *found);
    return measured ? movedTo(*found, *measured) : *found;
}

} // namespace autostereo::devices

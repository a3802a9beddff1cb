#include "daemon/session/attendance.hpp"

#include <cmath>

namespace autostereo::daemon {

namespace {

/// Without a depth frame for so long nobody can say that nobody is there.
constexpr std::chrono::seconds kBlind{2};

} // namespace

bool Attendance::isSomeone(const devices::Frame& depth) const {
    const double farthest = std::ceil(params_.presenceM / depth.metadata().depthUnitM);
    constexpr double kMostCounts = 65535; // which means no measurement, as 0 does
    const auto end = static_cast<std::uint16_t>(std::min(farthest, kMostCounts));
    auto missing = std::ceil(params_.presenceShare * static_cast<double>(depth.pixelCount()));
    for (const std::uint16_t count : depth.depth())
        if (count > 0 && count < end && --missing <= 0) return true;
    return false;
}

void Attendance::saw(const devices::Frame& depth, devices::TimePoint now) {
    if (params_.presenceM == 0 || !watched_ || now - *watched_ > kBlind || isSomeone(depth))
        someone_ = now;
    watched_ = now;
}

std::optional<Shown> Attendance::rest(devices::TimePoint now, const std::tm& local) const {
    constexpr int kWeek = 7, kSunday = 6; // std::tm counts from Sunday
    if (!config::isOpen(params_.hours, (local.tm_wday + kSunday) % kWeek,
                        60 * local.tm_hour + local.tm_min))
        return Shown::Closed;
    const bool watches = params_.presenceM > 0 && watched_ && now - *watched_ <= kBlind;
    if (watches && now - someone_ > params_.leave) return Shown::Nobody;
    return std::nullopt;
}

std::tm localTime() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    return local;
}

} // namespace autostereo::daemon

#include "devices/sim/plugged_source.hpp"

#include "devices/input.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>

namespace autostereo::devices::sim {

namespace {

bool isThere(const std::filesystem::path& plug) {
    std::error_code ignored;
    return std::filesystem::exists(plug, ignored);
}

bool isSilent(const std::filesystem::path& plug) {
    std::string word;
    std::ifstream(plug) >> word;
    return word == "silent";
}

/// The last exposure whose middle is over.
TimePoint lastExposure(TimePoint now, Duration period, Duration offset) {
    return TimePoint((now - offset).time_since_epoch() / period * period) + offset;
}

} // namespace

PluggedSource::PluggedSource(std::filesystem::path plug, std::unique_ptr<Source> source,
                             Duration period, Duration offset, Clock& clock)
    : plug_(std::move(plug)), source_(std::move(source)), period_(period), offset_(offset),
      clock_(clock), next_(lastExposure(clock.now(), period, offset)) {
    if (!isThere(plug_))
        throw DeviceError("sim: cannot open the camera of " + plug_.string() + ": no such file",
                          true);
}

ReadResult PluggedSource::read(TimePoint deadline) noexcept try {
    if (!isThere(plug_)) return Disconnected{plug_.filename().string() + " camera unplugged"};
    if (isSilent(plug_) || next_ > deadline) {
        clock_.sleepUntil(deadline);
        return Timeout{};
    }
    clock_.sleepUntil(next_);
    ReadResult result = source_->read(deadline);
    if (auto* frame = std::get_if<Frame>(&result)) frame->metadata().capturedAt = next_;
    // Exposures that were missed are gone.
    next_ = std::max(next_ + period_, lastExposure(clock_.now(), period_, offset_));
    return result;
} catch (const std::exception& error) {
    return Disconnected{error.what()};
}

} // namespace autostereo::devices::sim

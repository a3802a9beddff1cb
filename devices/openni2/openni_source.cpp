#include "devices/openni2/openni_source.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <span>
#include <utility>

namespace autostereo::devices::openni2 {

namespace {

constexpr Duration kSilence = std::chrono::seconds(3);
/// Stamps of a recording's pictures that were taken together lie closer.
constexpr Duration kOneMoment = std::chrono::milliseconds(4);
/// Frames without infrared of their number after which the two streams count apart.
constexpr int kMostMisses = 10;

} // namespace

OpenNiSource::OpenNiSource(std::unique_ptr<Device> device, Sensor main)
    : device_(std::move(device)), main_(main), lastArrival_(clock_.now()) {
    const StreamShape* depth = device_->stream(Sensor::Depth);
    const StreamShape* infrared = device_->stream(Sensor::Infrared);
    infrared_ = main == Sensor::Depth && depth != nullptr && infrared != nullptr &&
                depth->width == infrared->width && depth->height == infrared->height;
}

ReadResult OpenNiSource::read(TimePoint deadline) noexcept {
    constexpr Duration kSlice = std::chrono::milliseconds(20); // between looks at a lost device
    do {
        if (device_->lost()) return Disconnected{device_->uri() + " was unplugged or failed"};
        const Duration left = std::max(deadline - clock_.now(), Duration(0));
        auto picture = device_->next(std::min<Duration>(left, kSlice));
        const TimePoint now = clock_.now();
        if (!picture) {
            if (now - lastArrival_ > kSilence)
                return Disconnected{device_->uri() + " has sent nothing for 3 s"};
            continue;
        }
        lastArrival_ = now;
        if (auto frame = take(std::move(*picture), now)) {
            ++counters_.delivered;
            return std::move(*frame);
        }
    } while (clock_.now() < deadline);
    return Timeout{};
}

std::optional<Frame> OpenNiSource::take(Picture picture, TimePoint arrived) {
    if (picture.sensor() == main_) return takeMain(picture, arrived);
    if (!infrared_) return std::nullopt;
    if (waiting_.empty() || order(picture) > 0) {
        unmatched_ = std::move(picture); // it came before its depth
        return std::nullopt;
    }
    return withInfrared(picture);
}

std::optional<Frame> OpenNiSource::takeMain(const Picture& picture, TimePoint arrived) {
    const StreamShape& shape = *device_->stream(main_);
    const int step = picture.index() - lastIndex_; // some drivers start again at 1
    sequence_ += step > 0 ? static_cast<std::uint64_t>(step) : 1;
    lastIndex_ = picture.index();
    FrameMetadata metadata;
    metadata.format = shape.format;
    metadata.width = shape.width;
    metadata.height = shape.height;
    metadata.sequence = sequence_;
    metadata.capturedAt = device_->recording() ? TimePoint(picture.timestamp())
                                               : map_.map(picture.timestamp(), arrived);
    metadata.depthUnitM = shape.depthUnitM;
    metadata.hasAmplitude = infrared_;
    std::optional<Frame> frame = pool_.acquire(metadata);
    if (!frame) {
        ++counters_.starved;
        return std::nullopt;
    }
    if (!picture.copyTo(shape, frame->pixels())) {
        ++counters_.damaged;
        return std::nullopt;
    }
    if (!infrared_) return frame;
    if (!waiting_.empty()) {
        ++counters_.damaged;
        if (++misses_ >= kMostMisses) {
            spdlog::warn("openni2: {}: infrared and depth are numbered apart: no amplitudes",
                         device_->uri());
            infrared_ = false;
            waiting_ = Frame{};
            frame->metadata().hasAmplitude = false;
            return frame;
        }
    }
    waiting_ = std::move(*frame);
    waitingIndex_ = picture.index();
    waitingAt_ = picture.timestamp();
    if (!unmatched_ || order(*unmatched_) > 0) return std::nullopt;
    const Picture earlier = std::move(*std::exchange(unmatched_, std::nullopt));
    return withInfrared(earlier);
}

int OpenNiSource::order(const Picture& picture) {
    if (!device_->recording()) return picture.index() - waitingIndex_;
    if (!shift_) shift_ = waitingAt_ - picture.timestamp();
    const Duration off = picture.timestamp() + *shift_ - waitingAt_;
    return off > kOneMoment ? 1 : off < -kOneMoment ? -1 : 0;
}

std::optional<Frame> OpenNiSource::withInfrared(const Picture& picture) {
    if (order(picture) != 0) return std::nullopt;
    Frame frame = std::exchange(waiting_, Frame{});
    misses_ = 0;
    if (picture.copyTo(*device_->stream(Sensor::Infrared),
                       std::as_writable_bytes(frame.amplitude())))
        return frame;
    ++counters_.damaged;
    return std::nullopt;
}

} // namespace autostereo::devices::openni2

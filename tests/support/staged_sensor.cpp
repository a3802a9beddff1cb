#include "tests/support/staged_sensor.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <thread>

namespace autostereo::test {

using devices::Duration;
using devices::Frame;
using devices::FrameMetadata;
using devices::PixelFormat;
using devices::TimePoint;

namespace {

constexpr int kFlood = 20;
constexpr Duration kColorLater = std::chrono::milliseconds(4);

bool isAway(SensorFault fault) {
    return fault == SensorFault::Unplugged || fault == SensorFault::SlowToCome;
}

bool isAnotherMode(SensorFault fault) {
    return fault == SensorFault::OtherSize || fault == SensorFault::OtherFormat;
}

TimePoint lastExposure(TimePoint now, Duration period, Duration offset) {
    return TimePoint((now - offset).time_since_epoch() / period * period) + offset;
}

/// The form in which a sensor comes back in another mode.
FrameMetadata otherForm(FrameMetadata form, SensorFault fault) {
    const bool depth = form.format == PixelFormat::Depth16;
    if (fault == SensorFault::OtherSize) {
        form.width /= 2;
        form.height /= 2;
    } else if (fault == SensorFault::OtherFormat) {
        if (depth) form.depthUnitM = 0.0001;
        if (!depth) form.format = PixelFormat::Grey8;
    }
    form.encodedBytes = 0;
    return form;
}

/// Every so manieth pixel, and of each as many bytes as the other form has room for.
void copyPixels(const FrameMetadata& fromForm, std::span<const std::byte> from,
                const FrameMetadata& toForm, std::span<std::byte> to) {
    const auto pixels = [](const FrameMetadata& form) {
        return static_cast<std::size_t>(form.width) * static_cast<std::size_t>(form.height);
    };
    if (from.empty() || to.empty()) return;
    const std::size_t fromBytes = from.size() / pixels(fromForm),
                      bytes = to.size() / pixels(toForm);
    const auto step = static_cast<std::size_t>(fromForm.width / toForm.width);
    const auto width = static_cast<std::size_t>(toForm.width);
    for (std::size_t i = 0; i < pixels(toForm); ++i) {
        const std::size_t source =
            i / width * step * static_cast<std::size_t>(fromForm.width) + i % width * step;
        std::ranges::copy(from.subspan(source * fromBytes, std::min(fromBytes, bytes)),
                          to.begin() + static_cast<std::ptrdiff_t>(i * bytes));
    }
}

} // namespace

std::shared_ptr<const Reel> readReel(devices::Source& source, std::size_t pictures) {
    auto reel = std::make_shared<Reel>();
    while (reel->pictures.size() < pictures) {
        devices::ReadResult result = source.read(TimePoint::max());
        const auto* frame = std::get_if<Frame>(&result);
        if (frame == nullptr) break;
        const auto amplitude = std::as_bytes(frame->amplitude());
        reel->pictures.push_back({frame->metadata(),
                                  {frame->pixels().begin(), frame->pixels().end()},
                                  {amplitude.begin(), amplitude.end()}});
    }
    if (reel->pictures.empty()) throw std::runtime_error("an input without a picture");
    return reel;
}

std::uint64_t StagedSensor::exposureAt(TimePoint time, Duration period) {
    return static_cast<std::uint64_t>((time.time_since_epoch() + period / 2) / period);
}

StagedSensor::StagedSensor(std::shared_ptr<const Reel> reel, const SensorOrders& orders,
                           Duration period, Duration offset)
    : reel_(std::move(reel)), orders_(orders), period_(period), offset_(offset) {
    constexpr int kMostWaits = 500;
    for (int i = 0; i < kMostWaits && orders_.now().fault == SensorFault::SlowToCome; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    openedWith_ = orders_.now().fault;
    if (isAway(openedWith_)) throw devices::DeviceError("the sensor is unplugged", true);
    next_ = lastExposure(clock_.now(), period_, offset_);
}

devices::ReadResult StagedSensor::read(TimePoint deadline) noexcept try {
    const Order order = orders_.now();
    if (order.number != seen_) {
        seen_ = order.number;
        orderedAt_ = clock_.now();
    }
    if (isAway(order.fault)) return devices::Disconnected{"unplugged"};
    const SensorFault mode = isAnotherMode(order.fault) ? order.fault : SensorFault::None;
    const SensorFault opened = isAnotherMode(openedWith_) ? openedWith_ : SensorFault::None;
    if (mode != opened) return devices::Disconnected{"another mode"};
    const bool silent = order.fault == SensorFault::Silent || order.fault == SensorFault::Burst;
    holdsBack_ = holdsBack_ || order.fault == SensorFault::Burst;
    const TimePoint due = next_ + (order.fault == SensorFault::Late ? order.amount : Duration{0});
    if (silent || due > deadline) {
        clock_.sleepUntil(deadline);
        return devices::Timeout{};
    }
    clock_.sleepUntil(due);
    Frame frame = expose(order);
    advance(order);
    if (order.fault == SensorFault::Damaged) {
        ++counters_.damaged;
        return devices::Timeout{};
    }
    if (frame.empty()) {
        ++counters_.starved;
        return devices::Timeout{};
    }
    ++counters_.delivered;
    return frame;
} catch (const std::exception& error) {
    return devices::Disconnected{error.what()};
}

Frame StagedSensor::expose(const Order& order) {
    const std::uint64_t exposure = exposureAt(next_ - offset_, period_);
    const Reel::Picture& picture = reel_->pictures[exposure % reel_->pictures.size()];
    FrameMetadata form = otherForm(picture.form, openedWith_);
    form.capturedAt = stamp(order);
    if (order.fault == SensorFault::Numbered)
        numbered_ += exposure % 2 == 0 ? std::uint64_t{1} << 32U : std::uint64_t{1} << 53U;
    form.sequence = order.fault == SensorFault::Repeated ? 7 : exposure + numbered_;
    auto frame = pool_.acquire(form);
    if (!frame) return {};
    copyPixels(picture.form, picture.pixels, form, frame->pixels());
    copyPixels(picture.form, picture.amplitude, form, std::as_writable_bytes(frame->amplitude()));
    spoil(*frame, order);
    return std::move(*frame);
}

void StagedSensor::spoil(Frame& frame, const Order& order) {
    if (order.fault == SensorFault::Zero) std::ranges::fill(frame.pixels(), std::byte{0});
    if (order.fault == SensorFault::Saturated) std::ranges::fill(frame.pixels(), std::byte{0xff});
    if (order.fault == SensorFault::Garbage)
        std::ranges::generate(frame.pixels(),
                              [&] { return static_cast<std::byte>(random_() >> 8U); });
}

TimePoint StagedSensor::stamp(const Order& order) {
    switch (order.fault) {
    case SensorFault::Back:
        return next_ - order.amount;
    case SensorFault::Forward:
        return next_ + order.amount;
    case SensorFault::Extreme:
        return random_() % 2 == 0 ? TimePoint::min() : TimePoint::max();
    case SensorFault::Stuck:
        return orderedAt_;
    case SensorFault::Jitter:
        return next_ +
               Duration(static_cast<Duration::rep>(random_()) % (2 * order.amount.count())) -
               order.amount;
    case SensorFault::Drift:
        return next_ - (next_ - orderedAt_) / 10;
    default:
        return next_;
    }
}

/// Exposures that were missed are gone, but for those that are held back.
void StagedSensor::advance(const Order& order) {
    ++copies_;
    const int wanted = order.fault == SensorFault::Flood   ? kFlood
                       : order.fault == SensorFault::Twice ? 2
                                                           : 1;
    if (copies_ < wanted) {
        if (order.fault == SensorFault::Flood) next_ += period_ / kFlood;
        return;
    }
    copies_ = 0;
    const TimePoint newest = lastExposure(clock_.now(), period_, offset_);
    const TimePoint following = lastExposure(next_, period_, offset_) + period_;
    constexpr int kDriversBuffers = 4;
    const Duration behind = newest - following;
    holdsBack_ = holdsBack_ && behind > period_;
    const bool kept = holdsBack_ || order.fault == SensorFault::Late;
    next_ = kept || behind < kDriversBuffers * period_ ? following : newest;
}

devices::Input staged(devices::Input input, const SensorOrders& depth, const SensorOrders& color,
                      std::size_t pictures, Duration period) {
    const auto depthReel = readReel(*input.depth, pictures);
    const auto colorReel = readReel(*input.color, pictures);
    input.reopen.depth = [depthReel, &depth, period] {
        return std::make_unique<StagedSensor>(depthReel, depth, period, Duration{0});
    };
    input.reopen.color = [colorReel, &color, period] {
        return std::make_unique<StagedSensor>(colorReel, color, period, kColorLater);
    };
    input.depth = input.reopen.depth();
    input.color = input.reopen.color();
    input.depthIsLive = input.colorIsLive = true;
    input.nominalPeriod = period;
    return input;
}

} // namespace autostereo::test

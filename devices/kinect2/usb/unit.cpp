#include "devices/kinect2/usb/unit.hpp"

#include "devices/input.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include <pthread.h>

namespace autostereo::devices::kinect2 {

namespace {

using std::chrono::milliseconds;

constexpr int kInterfaces = 2;
/// 48 ms of isochronous intervals and half a picture: kUsbMemoryMib with what the kernel adds.
constexpr UsbStream::Shape kDepthStream{0x84, 12, 32, 33792};
constexpr UsbStream::Shape kColorStream{0x83, 8, 0, 32768};
/// Between looks at the stop token.
constexpr auto kSlice = milliseconds(50);

/// A late reader loses packets, a late decoder only pictures. Where the system does not permit it,
/// the transfers on their way have to do.
void becomeUrgent() {
    const sched_param lowest{1};
    pthread_setschedparam(pthread_self(), SCHED_RR, &lowest);
}

} // namespace

Unit::Unit(const UnitNode& node, std::shared_ptr<UnitPatience> patience,
           std::shared_ptr<RawTap> tap)
    : name_("kinect2 " + node.serial), patience_(std::move(patience)),
      link_(std::make_unique<UsbLink>(node.node, kInterfaces)), facts_(UnitControl(*link_).start()),
      newTap_(std::move(tap)) {
    startStreams();
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

Unit::~Unit() {
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
}

void Unit::startStreams() try {
    streams_.push_back(std::make_unique<UsbStream>(
        *link_, kColorStream,
        [this](std::span<const std::byte> bytes, bool intact) { takeColor(bytes, intact); }));
    streams_.push_back(std::make_unique<UsbStream>(
        *link_, kDepthStream,
        [this](std::span<const std::byte> bytes, bool intact) { takeDepth(bytes, intact); }));
    // Five of these periods: starting anew takes longer than a program that was kept waiting.
    patience_->depth.start(steadyNow(), milliseconds(100));
    patience_->color.start(steadyNow(), milliseconds(133)); // 15 pictures a second in the dark
} catch (const DeviceError&) {
    shutDown();
    throw;
}

Unit::Counters Unit::counters() const {
    const std::lock_guard lock(mutex_);
    return counters_;
}

std::string Unit::whyLost() const {
    const std::lock_guard lock(mutex_);
    return whyLost_;
}

void Unit::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "kinect2-usb");
    becomeUrgent();
    while (!stop.stop_requested() && !link_->lost()) {
        for (const auto& stream : streams_)
            if (!link_->lost()) stream->revive();
        takeNewTap();
        link_->handleEvents(kSlice);
        watchSilence();
    }
    {
        const std::lock_guard lock(mutex_);
        whyLost_ = name_ + ": " + link_->lost().value_or("it is being closed");
    }
    shutDown();
    lost_.store(true, std::memory_order_release); // now it may be opened again
    depth_.close();
    color_.close();
}

void Unit::watchSilence() {
    if (link_->lost()) return;
    const TimePoint time = steadyNow();
    for (SilenceWatch* watch : {&patience_->depth, &patience_->color}) {
        if (time < watch->deadline()) continue;
        watch->expired();
        link_->lose(watch == &patience_->depth ? "no depth comes any more"
                                               : "no colour comes any more");
    }
}

void Unit::takeDepth(std::span<const std::byte> packet, bool intact) {
    // Most are empty, and asking for the time costs more than they do.
    const TimePoint arrived = packet.empty() ? TimePoint{} : steadyNow();
    if (!packet.empty()) patience_->depth.frame(arrived, Duration(0));
    if (tap_) tap_->depth(packet, intact, arrived);
    const bool complete = packets_.depth(packet, intact, arrived, nextDepth_);
    if (!complete && intact) return;
    publishCounters();
    if (complete) depth_.put(nextDepth_);
}

void Unit::takeColor(std::span<const std::byte> packet, bool intact) {
    const TimePoint arrived = steadyNow();
    if (!packet.empty()) patience_->color.frame(arrived, Duration(0));
    if (tap_) tap_->color(packet, intact, arrived);
    const bool complete = packets_.color(packet, intact, arrived, nextColor_);
    if (!complete && intact) return;
    publishCounters();
    if (complete) color_.put(nextColor_);
}

void Unit::publishCounters() {
    const std::lock_guard lock(mutex_);
    static_cast<UnitPackets::Counters&>(counters_) = packets_.counters();
    counters_.depthUnderruns = streams_.back()->underruns();
}

void Unit::setTap(std::shared_ptr<RawTap> tap) {
    const std::lock_guard lock(mutex_);
    newTap_ = std::move(tap);
}

void Unit::takeNewTap() {
    const std::lock_guard lock(mutex_);
    if (!newTap_) return;
    tap_ = std::move(newTap_);
    tap_->start(facts_.pages, steadyNow());
}

void Unit::shutDown() try {
    constexpr auto kLongest = std::chrono::seconds(2);
    for (const auto& stream : streams_)
        stream->cancel();
    const TimePoint end = steadyNow() + kLongest;
    const auto idle = [&] {
        return std::ranges::all_of(streams_, [](const auto& stream) { return stream->idle(); });
    };
    while (!idle() && steadyNow() < end)
        link_->handleEvents(kSlice);
    if (!link_->lost() && idle()) UnitControl(*link_).stop();
    streams_.clear();
    link_.reset();
} catch (const std::exception& error) {
    spdlog::debug("{}: while it was stopped: {}", name_, error.what());
    streams_.clear();
    link_.reset();
}

} // namespace autostereo::devices::kinect2

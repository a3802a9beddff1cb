#include "tests/device/tof/kinect2_camera.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace autostereo::test {

namespace {

using usbip::Answer;
using usbip::Time;

constexpr std::size_t kIntervalBytes = 33792;
/// The first sub-image's footer lies in the last of its packets.
constexpr std::size_t kFooterAt = devices::kinect2::kSubImageBytes % kIntervalBytes;
constexpr std::size_t kPacketsOfSubImage = 10; // eight full ones, a short one, an empty one
constexpr auto kInterval = std::chrono::microseconds(125);
constexpr std::size_t kStampAt = kFooterAt + 8, kSequenceAt = kFooterAt + 12;

usbip::Bytes octets(std::span<const std::byte> bytes) {
    usbip::Bytes result(bytes.size());
    std::memcpy(result.data(), bytes.data(), bytes.size());
    return result;
}

std::uint32_t wordAt(std::span<const std::uint8_t> bytes, std::size_t index) {
    std::uint32_t word = 0;
    if (4 * index + 4 <= bytes.size()) std::memcpy(&word, bytes.data() + 4 * index, 4);
    return word;
}

void setWord(usbip::Bytes& bytes, std::size_t at, std::uint32_t word) {
    std::memcpy(bytes.data() + at, &word, sizeof word);
}

} // namespace

Kinect2Camera::Kinect2Camera(Kinect2Show show) : show_(std::move(show)) {
    for (const auto& exposure : show_.exposures) {
        Packets packets;
        for (const Bytes& packet : depthPackets(exposure))
            packets.push_back(octets(packet));
        depth_.push_back(std::move(packets));
    }
    poweredAt_ = std::chrono::steady_clock::now();
}

void Kinect2Camera::powerUp() {
    const std::lock_guard lock(mutex_);
    reset_ = true;
    streaming_.store(false);
}

void Kinect2Camera::setReplyFault(std::function<void(usbip::Bytes&)> fault) {
    const std::lock_guard lock(mutex_);
    replyFault_ = std::move(fault);
}

usbip::Descriptors Kinect2Camera::descriptors() const {
    using namespace usbip;
    Descriptors all;
    all.device = {18, 1, 0x00, 0x03, 0xef, 2, 1, 9, 0x5e, 0x04, 0xd8, 0x02, 0, 1, 1, 2, 3, 1};
    all.strings = {{1, "Emulated"}, {2, "Xbox NUI Sensor"}, {3, show_.serial}};
    all.capabilities = superSpeedCapabilities();
    usbip::Bytes& bytes = all.configuration = configurationHeader(2);
    const auto add = [&](Endpoint endpoint, unsigned most, const usbip::Bytes& companion) {
        put(bytes, endpointDescriptor(endpoint, most));
        put(bytes, companion);
    };
    const InterfaceKind kind{0xff, 0xff, 0xff};
    put(bytes, interfaceDescriptor(0, 0, 4, kind));
    add({kCommands, EndpointType::Bulk, 0}, 1024, companionDescriptor(0, 0, 0));
    add({kReplies, EndpointType::Bulk, 0}, 1024, companionDescriptor(15, 0, 0));
    add({0x82, EndpointType::Interrupt, 8}, 512, companionDescriptor(0, 0, 512));
    add({kColor, EndpointType::Bulk, 0}, 1024, companionDescriptor(15, 0, 0));
    put(bytes, interfaceDescriptor(1, 0, 0, kind));
    put(bytes, interfaceDescriptor(1, 1, 1, kind));
    add({kDepth, EndpointType::Isochronous, 1}, 1024, companionDescriptor(10, 2, kIntervalBytes));
    finishConfiguration(bytes);
    return all;
}

std::optional<usbip::Bytes> Kinect2Camera::control(const usbip::Setup&,
                                                   std::span<const std::uint8_t>) {
    return std::nullopt; // it has neither class nor vendor requests
}

Answer Kinect2Camera::write(std::uint8_t endpoint, std::span<const std::uint8_t> data, Time) {
    constexpr std::uint32_t kMagic = 0x06022009;
    if (endpoint != kCommands || data.size() < 20 || wordAt(data, 0) != kMagic)
        return Answer::stall();
    answer(wordAt(data, 1), wordAt(data, 3), wordAt(data, 5), wordAt(data, 2));
    return Answer::taken();
}

void Kinect2Camera::answer(std::uint32_t id, std::uint32_t command, std::uint32_t parameter,
                           std::uint32_t replyBytes) {
    const std::lock_guard lock(mutex_);
    if (std::exchange(reset_, false)) {
        replies_.clear();
        picture_ = {};
    }
    usbip::Bytes data = replyTo(command, parameter);
    data.resize(std::min<std::size_t>(data.size(), replyBytes));
    usbip::Bytes end = octets(completion(id));
    if (replyFault_) replyFault_(data);
    if (replyFault_) replyFault_(end);
    if (replyBytes > 0) replies_.push_back({std::move(data)});
    replies_.push_back({std::move(end)});
}

usbip::Bytes Kinect2Camera::serialPage() const {
    usbip::Bytes page(0x80);
    for (std::size_t i = 0; i < std::min<std::size_t>(show_.serial.size(), 64); ++i)
        page[2 * i] = static_cast<std::uint8_t>(show_.serial[i]);
    return page;
}

usbip::Bytes Kinect2Camera::replyTo(std::uint32_t command, std::uint32_t parameter) {
    switch (command) {
    case 0x02: { // seven entries of major.minor, build
        usbip::Bytes versions;
        for (std::uint32_t i = 0; i < 7; ++i)
            for (const std::uint32_t word : {4U << 16U, 3900 + i, 0U, 0U})
                usbip::put32(versions, word);
        return versions;
    }
    case 0x14:
        return usbip::Bytes(0x5c);
    case 0x16:
        if (sleep_.load() > 0) {
            --sleep_;
            return {0, 0, 0, 0};
        }
        return {1, 0, 0, 0};
    case 0x22:
        if (parameter == 1) return serialPage();
        if (parameter == 2) return octets(phasePage(show_.unit));
        if (parameter == 3) return octets(depthCameraPage(show_.unit));
        if (parameter == 4) return octets(colorPage(show_.unit));
        return {};
    case 0x2b:
        setStreaming(parameter == 1);
        return {};
    default:
        return {};
    }
}

void Kinect2Camera::setStreaming(bool on) {
    streaming_.store(on);
    colorNumber_ = 0;
    depthNumber_ = -1;
    since_ = std::chrono::steady_clock::now() + period();
}

Answer Kinect2Camera::read(std::uint8_t endpoint, std::size_t capacity, Time now) {
    constexpr auto kIdle = std::chrono::milliseconds(100);
    if (endpoint == kColor) return readColor(capacity, now);
    if (endpoint != kReplies || replies_.empty()) return Answer::later(now + kIdle);
    Answer chunk = Answer::with(replies_.front().next(capacity));
    if (replies_.front().done()) replies_.pop_front();
    return chunk;
}

usbip::Bytes Kinect2Camera::Outgoing::next(std::size_t capacity) {
    const std::size_t count = std::min(capacity, bytes.size() - sent);
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(sent);
    sent += count;
    return {from, from + static_cast<std::ptrdiff_t>(count)};
}

Answer Kinect2Camera::readColor(std::size_t capacity, Time now) {
    if (!streaming_.load()) return Answer::later(now + period());
    if (picture_.done()) {
        const Time due = since_ + colorNumber_ * period();
        if (now < due) return Answer::later(due);
        const auto& jpeg = show_.jpegs[static_cast<std::size_t>(colorNumber_) % show_.jpegs.size()];
        picture_ = {octets(colorPacket(std::as_bytes(std::span(jpeg)),
                                       static_cast<std::uint32_t>(colorNumber_), stampOf(due)))};
        // What nobody fetched in time is not sent later.
        colorNumber_ = std::max(colorNumber_ + 1, (now - since_) / period());
        ++colorFrames_;
    }
    return Answer::with(picture_.next(capacity));
}

usbip::Bytes Kinect2Camera::readInterval(std::uint8_t, std::size_t, Time interval) {
    if (!streaming_.load() || interval < since_) return {};
    const auto elapsed = interval - since_;
    const std::int64_t number = elapsed / period();
    const auto slot = static_cast<std::size_t>(elapsed % period() / kInterval);
    const Packets& packets = depth_[static_cast<std::size_t>(number) % depth_.size()];
    noteSlot(number, slot, packets.size());
    if (slot >= packets.size()) return {};
    usbip::Bytes packet = packets[slot];
    if (packet.size() > kFooterAt && packet.size() < kIntervalBytes) {
        setWord(packet, kStampAt, stampOf(since_ + number * period()));
        setWord(packet, kSequenceAt, static_cast<std::uint32_t>(number));
    }
    return packet;
}

Time Kinect2Camera::resumeAt(std::uint8_t endpoint, Time ended, Time now) {
    if (endpoint != kDepth || !streaming_.load() || ended < since_) return now;
    ++underruns_;
    const auto slot = static_cast<std::size_t>((ended - since_) % period() / kInterval);
    const std::size_t sent = slot % kPacketsOfSubImage;
    if (!treacherous_.load() || sent == 0 || slot >= depth_.front().size()) return now;
    // In the middle of an interval, so that rounding does not matter.
    const auto at = kInterval * static_cast<int>(sent) + kInterval / 2;
    const std::int64_t frame =
        std::max((now - since_ - at) / period(), (ended - since_) / period());
    return since_ + (frame + 1) * period() + at;
}

void Kinect2Camera::noteSlot(std::int64_t number, std::size_t slot, std::size_t slots) {
    const auto cut = [&] {
        if (!std::exchange(depthIsCut_, true)) ++depthCut_;
    };
    if (number != depthNumber_) {
        if (depthNumber_ >= 0 && depthSlot_ < slots) cut();
        depthNumber_ = number;
        depthSlot_ = 0;
        depthIsCut_ = false;
        if (slot < slots) ++depthFrames_;
    }
    if (depthSlot_ < slots && slot != depthSlot_) cut();
    depthSlot_ = slot + 1;
}

std::uint32_t Kinect2Camera::stampOf(Time time) const {
    return static_cast<std::uint32_t>((time - poweredAt_) / std::chrono::microseconds(125));
}

std::chrono::nanoseconds Kinect2Camera::period() const {
    return std::chrono::nanoseconds(static_cast<std::int64_t>(1e9 / show_.fps));
}

} // namespace autostereo::test

#include "tests/device/uvc/uvc_camera.hpp"

#include "tests/device/uvc/uvc_descriptors.hpp"

#include <algorithm>
#include <random>
#include <utility>

namespace autostereo::test {

namespace {

using usbip::Answer;
using usbip::Bytes;
using usbip::put, usbip::put32;
using usbip::Setup;

enum UvcRequest : std::uint8_t {
    SetNow = 0x01,
    GetNow = 0x81,
    GetLeast = 0x82,
    GetMost = 0x83,
    GetStep = 0x84,
    GetLength = 0x85,
    GetInfo = 0x86,
    GetStandard = 0x87,
};

constexpr unsigned kAgreementBytes = 34;
constexpr std::uint8_t kGetAndSet = 3;

long littleEndian(std::span<const std::uint8_t> bytes) {
    unsigned long value = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(bytes.size(), 4); ++i)
        value |= static_cast<unsigned long>(bytes[i]) << (8 * i);
    return static_cast<long>(value);
}

constexpr unsigned terminal(unsigned selector) { return kUvcTerminal << 8U | selector; }
constexpr unsigned processing(unsigned selector) { return kUvcProcessing << 8U | selector; }

} // namespace

UvcCamera::UvcCamera(UvcParams params) : params_(std::move(params)) {
    settings_ = {{terminal(2), {1, 1, 8, 8, 8}},         // exposure mode: aperture priority
                 {terminal(3), {1, 0, 1, 0, 1}},         // the frame rate may fall
                 {terminal(4), {4, 1, 5000, 156, 156}},  // exposure, 100 us
                 {processing(2), {2, 0, 255, 128, 128}}, // brightness
                 {processing(4), {2, 0, 100, 0, 0}},     // gain
                 {processing(5), {1, 0, 2, 2, 2}},       // power line: 60 Hz
                 {processing(0x0a), {2, 2800, 6500, 4600, 4600}},
                 {processing(0x0b), {1, 0, 1, 1, 1}}};
    probe_.interval = commit_.interval = 10'000'000 / params_.framesPerSecond.front();
}

void UvcCamera::setFaults(const UvcFaults& faults) {
    const std::lock_guard lock(mutex_);
    faults_ = faults;
}

long UvcCamera::control(unsigned which) const {
    const std::lock_guard lock(mutex_);
    return settings_.at(which).now;
}

usbip::Descriptors UvcCamera::descriptors() const {
    constexpr unsigned kMostBits = 2;
    usbip::Descriptors said = uvcDescriptors(params_);
    if (faults_.damagedDescriptors == 0) return said;
    std::mt19937 random(faults_.damagedDescriptors);
    Bytes& bytes = said.configuration;
    for (unsigned bits = 1 + random() % kMostBits; bits > 0; --bits)
        bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1U << random() % 8);
    return said;
}

std::optional<Bytes> UvcCamera::control(const Setup& setup, std::span<const std::uint8_t> data) {
    const unsigned interface = setup.index & 0xffU;
    return interface == 1 ? streaming(setup, data) : setting(setup, data);
}

std::optional<Bytes> UvcCamera::streaming(const Setup& setup, std::span<const std::uint8_t> data) {
    constexpr unsigned kProbe = 1, kCommit = 2;
    const unsigned selector = setup.value >> 8U;
    if (selector != kProbe && selector != kCommit) return std::nullopt;
    Agreement& agreement = selector == kProbe ? probe_ : commit_;
    switch (setup.request) {
    case SetNow: {
        const std::lock_guard lock(mutex_);
        if (faults_.refuses && selector == kCommit) return std::nullopt;
        agree(agreement, data);
        if (selector == kCommit) startStream();
        return Bytes{};
    }
    case GetLength:
        return Bytes{kAgreementBytes, 0};
    case GetInfo:
        return Bytes{kGetAndSet};
    default:
        return agreementBytes(agreement);
    }
}

void UvcCamera::agree(Agreement& agreement, std::span<const std::uint8_t> wanted) const {
    if (wanted.size() < 8) return;
    agreement.format =
        static_cast<std::uint8_t>(std::clamp<std::size_t>(wanted[2], 1, params_.formats.size()));
    const long interval = littleEndian(wanted.subspan(4));
    agreement.interval = 0;
    for (const unsigned rate : params_.framesPerSecond) { // the slowest that is fast enough
        const std::uint32_t offered = 10'000'000 / rate;
        if (agreement.interval == 0 || (offered <= interval && offered > agreement.interval))
            agreement.interval = offered;
    }
}

std::uint32_t UvcCamera::frameBytes(const UvcFormat& format) const {
    return static_cast<std::uint32_t>(format.width * format.height * 2);
}

Bytes UvcCamera::agreementBytes(const Agreement& agreement) const {
    const std::lock_guard lock(mutex_);
    Bytes bytes;
    put(bytes, {1, 0, agreement.format, agreement.frame});
    put32(bytes, agreement.interval);
    bytes.resize(18);
    const UvcFormat& format = params_.formats[agreement.format - 1U];
    put32(bytes, faults_.absurdSizes ? 0xffffffffU : frameBytes(format));
    put32(bytes, params_.isochronous ? kUvcIntervalBytes : kUvcBulkPayload);
    bytes.resize(kAgreementBytes);
    return bytes;
}

std::optional<Bytes> UvcCamera::setting(const Setup& setup, std::span<const std::uint8_t> data) {
    const std::lock_guard lock(mutex_);
    const auto found =
        settings_.find((static_cast<unsigned>(setup.index) & 0xff00U) | setup.value >> 8U);
    if (found == settings_.end()) return std::nullopt;
    Control& control = found->second;
    long value = control.now;
    switch (setup.request) {
    case SetNow:
        control.now = littleEndian(data);
        return Bytes{};
    case GetLength:
        return Bytes{static_cast<std::uint8_t>(control.bytes), 0};
    case GetInfo:
        return Bytes{kGetAndSet};
    case GetLeast:
        value = control.least;
        break;
    case GetMost:
        value = control.most;
        break;
    case GetStep: // of the exposure mode: a mask of those that there are
        value = found->first == terminal(2) ? 0x09 : 1;
        break;
    case GetStandard:
        value = control.standard;
        break;
    default:
        break;
    }
    Bytes bytes;
    put32(bytes, static_cast<std::uint32_t>(value));
    bytes.resize(control.bytes);
    return bytes;
}

void UvcCamera::setInterface(std::uint8_t interface, std::uint8_t alternate) {
    if (interface == 1) streaming_ = params_.isochronous && alternate == 1;
    inFrame_ = false;
}

void UvcCamera::clearHalt(std::uint8_t /*endpoint*/) { streaming_ = inFrame_ = false; }

void UvcCamera::startStream() {
    streaming_ = !params_.isochronous; // else with the alternate setting
    inFrame_ = false;
    frame_ = 0;
    nextFrame_ = std::chrono::steady_clock::now();
}

bool UvcCamera::begin(usbip::Time now) {
    if (!streaming_ || now < nextFrame_) return false;
    const std::lock_guard lock(mutex_);
    if (faults_.silentAfter != 0 && frame_ >= faults_.silentAfter) return false;
    const auto interval = std::chrono::nanoseconds(commit_.interval * 100LL);
    nextFrame_ = std::max(nextFrame_ + interval, now - interval);
    ++frame_;
    const UvcFormat& format = params_.formats[commit_.format - 1U];
    if (format.kind == UvcFormat::Kind::Mjpeg) {
        picture_ = format.jpegs[frame_ % format.jpegs.size()];
    } else {
        picture_.assign(frameBytes(format), 128);
        for (std::size_t i = 0; i < picture_.size(); i += 2)
            picture_[i] = lumaOf(frame_);
    }
    const auto every = [this](unsigned period) { return period != 0 && frame_ % period == 0; };
    if (every(faults_.halfEvery)) picture_.resize(picture_.size() / 2);
    error_ = every(faults_.errorEvery);
    sent_ = 0;
    inFrame_ = true;
    return true;
}

Bytes UvcCamera::payload(std::size_t capacity) {
    constexpr unsigned kHeaderBytes = 2, kEndOfHeader = 0x80, kError = 0x40, kLast = 0x02;
    const std::size_t count = std::min(capacity - kHeaderBytes, picture_.size() - sent_);
    const bool last = sent_ + count == picture_.size();
    Bytes bytes;
    bytes.reserve(count + kHeaderBytes);
    put(bytes,
        {kHeaderBytes, kEndOfHeader | (frame_ & 1U) | (last ? kLast : 0) | (error_ ? kError : 0)});
    const auto from = picture_.begin() + static_cast<std::ptrdiff_t>(sent_);
    bytes.insert(bytes.end(), from, from + static_cast<std::ptrdiff_t>(count));
    sent_ += count;
    if (last) {
        inFrame_ = false;
        framesSent_.fetch_add(1);
    }
    return bytes;
}

Answer UvcCamera::read(std::uint8_t /*endpoint*/, std::size_t capacity, usbip::Time now) {
    constexpr auto kIdle = std::chrono::milliseconds(5);
    if (!inFrame_ && !begin(now))
        return Answer::later(streaming_ && nextFrame_ > now ? nextFrame_ : now + kIdle);
    return Answer::with(payload(std::min<std::size_t>(capacity, kUvcBulkPayload)));
}

Bytes UvcCamera::readInterval(std::uint8_t /*endpoint*/, std::size_t capacity,
                              usbip::Time interval) {
    if (!inFrame_ && !begin(interval)) return {};
    return payload(std::min<std::size_t>(capacity, kUvcIntervalBytes));
}

} // namespace autostereo::test

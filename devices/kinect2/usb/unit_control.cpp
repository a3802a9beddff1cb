#include "devices/kinect2/usb/unit_control.hpp"

#include "devices/input.hpp"

#include <chrono>
#include <thread>
#include <utility>

namespace autostereo::devices::kinect2 {

namespace {

constexpr std::uint8_t kCommands = 0x02, kReplies = 0x81;
constexpr Duration kPatience = std::chrono::milliseconds(1000);
constexpr int kStreamInterface = 1;

// Standard requests of USB 3, and who they are for.
constexpr std::uint8_t kToDevice = 0, kToInterface = 1;
constexpr std::uint8_t kSetFeature = 3, kSetIsochDelay = 49;
constexpr std::uint16_t kFunctionSuspend = 0, kU1Enable = 48, kU2Enable = 49;
constexpr std::uint16_t kIsochDelayNs = 40;

} // namespace

// Replies that another program did not wait for carry numbers of its own.
UnitControl::UnitControl(UsbLink& link)
    : link_(link), lastId_(static_cast<std::uint32_t>(
                       std::chrono::steady_clock::now().time_since_epoch().count())) {}

std::vector<std::byte> UnitControl::ask(Command command, std::uint32_t replyBytes,
                                        std::initializer_list<std::uint32_t> parameters) {
    const std::uint32_t id = ++lastId_;
    link_.write(kCommands, encodeCommand(id, command, replyBytes, parameters), kPatience);
    std::vector<std::byte> reply;
    if (replyBytes > 0) reply = link_.read(kReplies, replyBytes, kPatience);
    const auto completion = link_.read(kReplies, kCompletionBytes, kPatience);
    if (const auto problem = problemWithCompletion(completion, id))
        throw DeviceError("kinect2: the camera answers command " +
                          std::to_string(static_cast<std::uint32_t>(command)) + " with " +
                          *problem + " (unplug it, plug it in again)");
    return reply;
}

void UnitControl::tell(Command command, std::initializer_list<std::uint32_t> parameters) {
    static_cast<void>(ask(command, 0, parameters));
}

std::vector<std::byte> UnitControl::page(Page which, std::uint32_t most) {
    return ask(Command::ReadPage, most, {static_cast<std::uint32_t>(which)});
}

void UnitControl::forgetOldReplies() {
    constexpr int kMost = 16;
    for (int i = 0; i < kMost; ++i)
        if (link_.read(kReplies, kPageBytes, std::chrono::milliseconds(10)).empty()) return;
}

void UnitControl::waitUntilReady() {
    constexpr int kTries = 50;
    for (int i = 0; i < kTries; ++i) {
        if (isReady(ask(Command::ReadStatus, kStatusBytes, {kReadyStatus}))) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    throw DeviceError(
        "kinect2: the camera is not ready after 5 s (is its power supply plugged in?)");
}

void UnitControl::pulseMode() {
    tell(Command::SetMode, {1, 0x00640064, 0, 0});
    tell(Command::SetMode, {0, 0, 0, 0});
}

void UnitControl::suspendFunction(bool suspended) {
    constexpr std::uint16_t kLowPowerAndWake = 3U << 8U; // high byte; the low one is the interface
    link_.request(kToInterface, kSetFeature, kFunctionSuspend, suspended ? kLowPowerAndWake : 0);
}

UnitFacts UnitControl::start() {
    link_.request(kToDevice, kSetIsochDelay, kIsochDelayNs, 0);
    link_.setAlternate(kStreamInterface, 0);
    link_.request(kToDevice, kSetFeature, kU1Enable, 0);
    link_.request(kToDevice, kSetFeature, kU2Enable, 0);
    suspendFunction(false);
    forgetOldReplies();

    UnitPages pages;
    pages.firmware = firmwareVersion(ask(Command::ReadVersions, kVersionsBytes, {}));
    static_cast<void>(ask(Command::ReadHardwareInfo, kHardwareInfoBytes, {}));
    pages.serial = serialNumber(page(Page::Serial, kSerialBytes));
    pages.depth = page(Page::DepthCamera);
    pages.phases = page(Page::PhaseOffsets);
    pages.color = page(Page::ColorCamera);
    UnitFacts facts = parseFacts(std::move(pages)); // before anything is started for nothing

    pulseMode();
    waitUntilReady();
    tell(Command::InitStreams, {});
    link_.setAlternate(kStreamInterface, 1);
    static_cast<void>(ask(Command::ReadStatus, kStatusBytes, {kReadyStatus}));
    tell(Command::EnableStream, {1});
    return facts;
}

void UnitControl::stop() {
    link_.setAlternate(kStreamInterface, 0);
    pulseMode();
    tell(Command::StopStreams, {});
    tell(Command::EnableStream, {0});
    pulseMode();
    pulseMode();
    suspendFunction(true);
}

} // namespace autostereo::devices::kinect2

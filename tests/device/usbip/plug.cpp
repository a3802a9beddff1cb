#include "tests/device/usbip/plug.hpp"

#include "tests/device/usbip/virtual_port.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <poll.h>
#include <pthread.h>
#include <sys/socket.h>
#include <utility>

namespace autostereo::test::usbip {

namespace {

using std::chrono::milliseconds;

/// Longest time without a look at the stop token and at new faults.
constexpr auto kSlice = milliseconds(10);

namespace request {
constexpr std::uint8_t kGetStatus = 0, kClearFeature = 1, kGetDescriptor = 6, kGetConfiguration = 8,
                       kSetInterface = 11;
} // namespace request

constexpr std::uint8_t kToEndpoint = 2, kRecipientMask = 0x1f;

void becomeUrgent(pid_t thread, int priority) {
    const sched_param wanted{priority};
    sched_setscheduler(thread, SCHED_FIFO, &wanted); // root may
}

/// A bus does not wait for programs: the kernel's threads between controller and wire run first,
/// then the device's.
void makeBusUrgent() {
    becomeUrgent(0, 2);
    std::error_code error;
    for (const auto& process : std::filesystem::directory_iterator("/proc", error)) {
        std::string name;
        std::getline(std::ifstream(process.path() / "comm"), name);
        if (name == "vhci_rx" || name == "vhci_tx")
            becomeUrgent(std::stoi(process.path().filename().string()), 3);
    }
}

} // namespace

Plug::Plug(Device& device, Speed speed)
    : device_(device), descriptors_(device.descriptors()),
      endpoints_(endpointsOf(descriptors_.configuration)) {
    for (const auto& [address, endpoint] : endpoints_)
        pipes_.try_emplace(address, device_, endpoint);
    AttachedPort attached = attachToPort(speed);
    port_ = attached.number;
    wire_.emplace(std::move(attached.socket));
    plugged_.store(true);
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

Plug::~Plug() { pull(); }

bool Plug::possible() { return hasVirtualPorts(); }

void Plug::pull() {
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    while (!isFree(port_) && std::chrono::steady_clock::now() < limit)
        std::this_thread::sleep_for(milliseconds(1));
}

void Plug::setFaults(std::uint8_t endpoint, const Faults& faults) {
    const std::lock_guard lock(mutex_);
    newFaults_[endpoint] = faults;
}

void Plug::takeFaults() {
    const std::lock_guard lock(mutex_);
    for (const auto& [endpoint, faults] : std::exchange(newFaults_, {}))
        if (const auto pipe = pipes_.find(endpoint); pipe != pipes_.end())
            pipe->second.setFaults(faults);
}

void Plug::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "usb-device");
    makeBusUrgent();
    while (!stop.stop_requested() && serve()) {
    }
    wire_.reset(); // the far end reads its end: the kernel lets the device go
    plugged_.store(false);
}

bool Plug::serve() {
    takeFaults();
    const Time now = std::chrono::steady_clock::now();
    // First what the host sent: a controller has it at once, and what came before a transfer's end
    // follows it without a gap, however late this thread is.
    constexpr int kMost = 256;
    for (int i = 0; i < kMost && hostSpeaks(std::chrono::nanoseconds(0)); ++i)
        if (!receive()) return false;
    for (auto& [address, pipe] : pipes_)
        if (!pipe.serve(*wire_, now)) return false;
    Time until = now + kSlice;
    for (const auto& [address, pipe] : pipes_)
        until = std::min(until, pipe.due().value_or(until));
    const auto left = std::max(std::chrono::nanoseconds(0),
                               std::chrono::nanoseconds(until - std::chrono::steady_clock::now()));
    static_cast<void>(hostSpeaks(left));
    return true;
}

bool Plug::hostSpeaks(std::chrono::nanoseconds patience) const {
    const timespec timeout{0, static_cast<long>(patience.count())};
    pollfd host{wire_->fd(), POLLIN, 0};
    return ppoll(&host, 1, &timeout, nullptr) > 0;
}

bool Plug::receive() {
    auto request = wire_->receive(endpoints_);
    if (!request) return false;
    return std::visit([this](auto& one) { return handle(std::move(one)); }, *request);
}

bool Plug::handle(Unlink unlink) {
    const bool found = std::ranges::any_of(
        pipes_, [&](auto& entry) { return entry.second.remove(unlink.victim); });
    return wire_->unlinked(unlink, found);
}

bool Plug::handle(Submit submit) {
    for (auto& [address, pipe] : pipes_)
        pipe.poke();
    const auto pipe = pipes_.find(submit.endpoint);
    if (pipe == pipes_.end()) return control(submit);
    pipe->second.push(std::move(submit));
    return true;
}

bool Plug::control(const Submit& submit) {
    const Setup& setup = submit.setup;
    std::optional<Bytes> answer;
    if ((submit.endpoint & 0xfU) == 0)
        answer = setup.standard() ? standardAnswer(setup) : device_.control(setup, submit.data);
    if (!answer) return wire_->reply(submit, Status::Stall, {});
    answer->resize(std::min<std::size_t>(answer->size(), submit.length));
    return wire_->reply(submit, Status::Good, *answer);
}

std::optional<Bytes> Plug::standardAnswer(const Setup& setup) {
    switch (setup.request) {
    case request::kGetStatus:
        return Bytes{0, 0};
    case request::kClearFeature:
        if ((setup.requestType & kRecipientMask) == kToEndpoint)
            device_.clearHalt(static_cast<std::uint8_t>(setup.index));
        return Bytes{};
    case request::kGetConfiguration:
        return Bytes{1};
    case request::kSetInterface:
        device_.setInterface(static_cast<std::uint8_t>(setup.index),
                             static_cast<std::uint8_t>(setup.value));
        return Bytes{};
    case request::kGetDescriptor:
        break;
    default: // SET_CONFIGURATION, SET_FEATURE, SET_ISOCH_DELAY: nothing to be done
        return Bytes{};
    }
    const auto type = static_cast<unsigned>(setup.value) >> 8U;
    if (type == 1) return descriptors_.device;
    if (type == 2) return descriptors_.configuration;
    Bytes bytes;
    if (type == 3) bytes = stringDescriptor(descriptors_, static_cast<std::uint8_t>(setup.value));
    if (type == 15) bytes = descriptors_.capabilities;
    if (bytes.empty()) return std::nullopt;
    return bytes;
}

} // namespace autostereo::test::usbip

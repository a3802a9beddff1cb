#include "devices/openni2/openni_session.hpp"

#include "devices/input.hpp"

#include <OniCAPI.h>

#include <algorithm>

namespace autostereo::devices::openni2 {

namespace {

std::mutex sessionMutex; // NOLINT: guards the one session of the process
std::weak_ptr<Session> session;

} // namespace

std::string lastReason() {
    std::string text = oniGetExtendedError();
    for (char& letter : text)
        if (letter < ' ') letter = ' ';
    text.erase(text.find_last_not_of(' ') + 1);
    return text.empty() ? "the library gives no reason" : text;
}

std::shared_ptr<Session> Session::get() {
    const std::lock_guard lock(sessionMutex);
    auto shared = session.lock();
    if (!shared) {
        shared = std::shared_ptr<Session>(new Session);
        session = shared;
    }
    return shared;
}

Session::Session() {
    if (oniInitialize(ONI_API_VERSION) != ONI_STATUS_OK)
        throw DeviceError("openni2: cannot load the OpenNI2 library's drivers: " + lastReason());
    OniDeviceCallbacks callbacks{};
    callbacks.deviceDisconnected = [](const OniDeviceInfo* info, void* self) {
        static_cast<Session*>(self)->noteLoss(info->uri);
    };
    callbacks.deviceStateChanged = [](const OniDeviceInfo* info, OniDeviceState state, void* self) {
        if (state == ONI_DEVICE_STATE_ERROR) static_cast<Session*>(self)->noteLoss(info->uri);
    };
    if (oniRegisterDeviceCallbacks(&callbacks, this, &callbacks_) != ONI_STATUS_OK) {
        oniShutdown();
        throw DeviceError("openni2: cannot listen for lost devices: " + lastReason());
    }
}

Session::~Session() {
    oniUnregisterDeviceCallbacks(callbacks_);
    oniShutdown();
}

std::vector<FoundDevice> Session::devices() const {
    OniDeviceInfo* list = nullptr;
    int count = 0;
    std::vector<FoundDevice> result;
    if (oniGetDeviceList(&list, &count) != ONI_STATUS_OK) return result;
    for (int i = 0; i < count; ++i)
        result.push_back(
            {list[i].uri, list[i].vendor, list[i].name, list[i].usbVendorId, list[i].usbProductId});
    oniReleaseDeviceList(list);
    return result;
}

std::optional<std::uint64_t> Session::enter(const std::string& uri) {
    const std::lock_guard lock(mutex_);
    const std::uint64_t losses = losses_[uri];
    const auto [first, last] = open_.equal_range(uri);
    if (std::any_of(first, last, [&](const auto& open) { return open.second != losses; }))
        return std::nullopt;
    open_.emplace(uri, losses);
    return losses;
}

void Session::leave(const std::string& uri, std::uint64_t losses) {
    const std::lock_guard lock(mutex_);
    const auto [first, last] = open_.equal_range(uri);
    const auto found =
        std::find_if(first, last, [&](const auto& open) { return open.second == losses; });
    if (found != last) open_.erase(found);
}

std::uint64_t Session::losses(const std::string& uri) const {
    const std::lock_guard lock(mutex_);
    const auto found = losses_.find(uri);
    return found == losses_.end() ? 0 : found->second;
}

void Session::noteLoss(const char* uri) {
    const std::lock_guard lock(mutex_);
    ++losses_[uri];
}

} // namespace autostereo::devices::openni2

#include "devices/kinect2/usb/usb_link.hpp"

#include "devices/input.hpp"
#include "devices/kinect2/usb/find_units.hpp"

#include <libusb.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <poll.h>

namespace autostereo::devices::kinect2 {

namespace {

constexpr unsigned kControlMs = 1000;

UniqueFd openNode(const std::string& node) {
    UniqueFd fd(open(node.c_str(), O_RDWR | O_CLOEXEC));
    if (fd.get() >= 0) return fd;
    const int error = errno;
    const bool gone = error == ENOENT || error == ENODEV;
    throw DeviceError(
        "kinect2: cannot open " + node + ": " + std::strerror(error) +
            (error == EACCES || error == EPERM ? std::string("; ") + kHowToPermit : ""),
        gone);
}

/// At least 1: libusb takes 0 for no limit.
unsigned milliseconds(Duration time) {
    const auto count = std::chrono::duration_cast<std::chrono::milliseconds>(time).count();
    return static_cast<unsigned>(std::clamp<std::int64_t>(count, 1, 60'000));
}

} // namespace

void UsbLink::ContextFreer::operator()(libusb_context* context) const noexcept {
    libusb_exit(context);
}
void UsbLink::HandleFreer::operator()(libusb_device_handle* handle) const noexcept {
    libusb_close(handle);
}

UsbLink::UsbLink(const std::filesystem::path& node, int interfaces)
    : node_(node.string()), fd_(openNode(node_)) {
    libusb_context* context = nullptr;
    check(libusb_init(&context), "start libusb");
    context_.reset(context);
    libusb_device_handle* handle = nullptr;
    check(libusb_wrap_sys_device(context, fd_.get(), &handle), "open it");
    handle_.reset(handle);
    int configuration = 0;
    check(libusb_get_configuration(handle, &configuration), "ask for its configuration");
    if (configuration != 1) check(libusb_set_configuration(handle, 1), "configure it");
    for (; claimed_ < interfaces; ++claimed_)
        check(libusb_claim_interface(handle, claimed_), "take it over");
}

UsbLink::~UsbLink() {
    while (handle_ && claimed_ > 0)
        libusb_release_interface(handle_.get(), --claimed_);
}

void UsbLink::fail(const std::string& tried, const std::string& why) const {
    throw DeviceError("kinect2: cannot " + tried + " (" + node_ + "): " + why);
}

int UsbLink::check(int answer, const char* tried) {
    if (answer >= 0) return answer;
    if (answer == LIBUSB_ERROR_NO_DEVICE) lose("it was unplugged");
    fail(tried, lost_.value_or(libusb_strerror(static_cast<libusb_error>(answer))) +
                    (answer == LIBUSB_ERROR_BUSY ? "; is another program using it?" : ""));
}

void UsbLink::checkNotLost(const char* tried) const {
    if (lost_) fail(tried, *lost_);
}

void UsbLink::lose(std::string reason) {
    if (!lost_) lost_ = std::move(reason);
}

void UsbLink::setAlternate(int interface, int alternate) {
    checkNotLost("switch its stream");
    check(libusb_set_interface_alt_setting(handle_.get(), interface, alternate),
          "switch its stream");
}

void UsbLink::request(std::uint8_t recipient, std::uint8_t request, std::uint16_t value,
                      std::uint16_t index) {
    checkNotLost("set it up");
    const int answer = libusb_control_transfer(handle_.get(), recipient, request, value, index,
                                               nullptr, 0, kControlMs);
    if (answer != LIBUSB_ERROR_PIPE) check(answer, "set it up");
}

void UsbLink::write(std::uint8_t endpoint, std::span<const std::byte> bytes, Duration patience) {
    checkNotLost("ask it");
    std::vector<std::byte> copy(bytes.begin(), bytes.end()); // libusb takes no constants
    int sent = 0;
    check(libusb_bulk_transfer(handle_.get(), endpoint,
                               reinterpret_cast<unsigned char*>(copy.data()),
                               static_cast<int>(copy.size()), &sent, milliseconds(patience)),
          "ask it");
    if (sent != static_cast<int>(copy.size())) fail("ask it", "it took only a part");
}

std::vector<std::byte> UsbLink::read(std::uint8_t endpoint, std::size_t most, Duration patience) {
    checkNotLost("read its answer");
    std::vector<std::byte> bytes(most);
    int received = 0;
    const int answer = libusb_bulk_transfer(
        handle_.get(), endpoint, reinterpret_cast<unsigned char*>(bytes.data()),
        static_cast<int>(most), &received, milliseconds(patience));
    if (answer != LIBUSB_ERROR_TIMEOUT) check(answer, "read its answer");
    bytes.resize(static_cast<std::size_t>(std::clamp(received, 0, static_cast<int>(most))));
    return bytes;
}

bool UsbLink::somethingEnded() const {
    pollfd node{fd_.get(), POLLOUT, 0}; // so usbfs says it
    return poll(&node, 1, 0) != 0;
}

void UsbLink::handleEvents(Duration atMost) {
    const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(atMost).count();
    timeval limit{static_cast<time_t>(microseconds / 1'000'000),
                  static_cast<suseconds_t>(microseconds % 1'000'000)};
    const int answer = libusb_handle_events_timeout_completed(context_.get(), &limit, nullptr);
    if (answer < 0 && answer != LIBUSB_ERROR_INTERRUPTED)
        lose(std::string("libusb: ") + libusb_strerror(static_cast<libusb_error>(answer)));
}

} // namespace autostereo::devices::kinect2

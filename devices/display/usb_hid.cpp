#include "devices/display/usb_hid.hpp"

#include "devices/input.hpp"

#include <libusb.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace autostereo::devices {

namespace {

constexpr std::uint16_t kVendor = 0x04d8;
constexpr std::uint16_t kProduct = 0xef7e;

struct ContextFreer {
    void operator()(libusb_context* context) const { libusb_exit(context); }
};
struct ListFreer {
    void operator()(libusb_device** list) const { libusb_free_device_list(list, 1); }
};
struct ConfigFreer {
    void operator()(libusb_config_descriptor* config) const {
        libusb_free_config_descriptor(config);
    }
};
struct HandleFreer {
    void operator()(libusb_device_handle* handle) const { libusb_close(handle); }
};
using Context = std::unique_ptr<libusb_context, ContextFreer>;
using DeviceList = std::unique_ptr<libusb_device*, ListFreer>;
using Config = std::unique_ptr<libusb_config_descriptor, ConfigFreer>;
using Handle = std::unique_ptr<libusb_device_handle, HandleFreer>;

void check(int status, const char* tried) {
    if (status >= 0) return;
    throw DeviceError(std::string("looking glass (USB 04d8:ef7e): cannot ") + tried + ": " +
                      libusb_strerror(static_cast<libusb_error>(status)) +
                      (status == LIBUSB_ERROR_ACCESS ? " (a udev rule has to give access)" : "") +
                      (status == LIBUSB_ERROR_BUSY ? " (is another program using it?)" : ""));
}

/// The HID interface and the endpoint that its replies come from.
struct HidInterface {
    int number;
    std::uint8_t endpoint;
};

std::optional<HidInterface> hidInterface(libusb_device* device) {
    libusb_config_descriptor* raw = nullptr;
    check(libusb_get_active_config_descriptor(device, &raw), "read its descriptor");
    const Config config(raw);
    for (int i = 0; i < config->bNumInterfaces; ++i) {
        if (config->interface[i].num_altsetting < 1) continue;
        const libusb_interface_descriptor& one = config->interface[i].altsetting[0];
        if (one.bInterfaceClass != LIBUSB_CLASS_HID) continue;
        for (int e = 0; e < one.bNumEndpoints; ++e) {
            const auto address = one.endpoint[e].bEndpointAddress;
            if ((address & LIBUSB_ENDPOINT_DIR_MASK) == LIBUSB_ENDPOINT_IN)
                return HidInterface{one.bInterfaceNumber, address};
        }
    }
    return std::nullopt;
}

class UsbHid final : public HidTransport {
  public:
    UsbHid(Context context, Handle handle, HidInterface interface)
        : context_(std::move(context)), handle_(std::move(handle)), interface_(interface) {
        libusb_set_auto_detach_kernel_driver(handle_.get(), 1);
        check(libusb_claim_interface(handle_.get(), interface_.number), "take it over");
    }
    ~UsbHid() override { libusb_release_interface(handle_.get(), interface_.number); }
    UsbHid(const UsbHid&) = delete;
    UsbHid& operator=(const UsbHid&) = delete;

    [[nodiscard]] std::optional<Report> exchange(const Report& request,
                                                 TimePoint deadline) override {
        constexpr std::uint8_t kToInterface = 0x21; // class request, from the host to an interface
        // SET_REPORT of a feature report without a number: the number's byte stays here.
        constexpr std::uint8_t kSetReport = 0x09;
        constexpr std::uint16_t kFeature = 3U << 8U;
        Report copy = request;
        check(libusb_control_transfer(handle_.get(), kToInterface, kSetReport, kFeature,
                                      static_cast<std::uint16_t>(interface_.number),
                                      reinterpret_cast<unsigned char*>(copy.data() + 1),
                                      kReportBytes - 1, millisecondsTo(deadline)),
              "ask it");
        Report reply{};
        int received = 0;
        const int status = libusb_interrupt_transfer(
            handle_.get(), interface_.endpoint, reinterpret_cast<unsigned char*>(reply.data()),
            static_cast<int>(reply.size()), &received, millisecondsTo(deadline));
        if (status == LIBUSB_ERROR_TIMEOUT || status == LIBUSB_ERROR_OVERFLOW) return std::nullopt;
        check(status, "read its answer");
        if (received != static_cast<int>(reply.size())) return std::nullopt;
        return reply;
    }

  private:
    /// At least 1: libusb takes 0 for no limit.
    static unsigned millisecondsTo(TimePoint deadline) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
            deadline - std::chrono::steady_clock::now());
        return static_cast<unsigned>(std::clamp<std::int64_t>(left.count(), 1, 10'000));
    }

    Context context_; // outlives the handle
    Handle handle_;
    HidInterface interface_;
};

} // namespace

std::unique_ptr<HidTransport> openLookingGlassHid(std::size_t index) {
    libusb_context* rawContext = nullptr;
    if (libusb_init(&rawContext) != 0) return nullptr; // a machine without USB
    Context context(rawContext);
    libusb_device** rawList = nullptr;
    const ssize_t count = libusb_get_device_list(context.get(), &rawList);
    if (count < 0) return nullptr;
    const DeviceList list(rawList);
    for (ssize_t i = 0; i < count; ++i) {
        libusb_device_descriptor about{};
        if (libusb_get_device_descriptor(rawList[i], &about) != 0 || about.idVendor != kVendor ||
            about.idProduct != kProduct || index-- != 0)
            continue;
        const auto interface = hidInterface(rawList[i]);
        if (!interface) throw DeviceError("looking glass (USB 04d8:ef7e): it has no HID interface");
        libusb_device_handle* rawHandle = nullptr;
        check(libusb_open(rawList[i], &rawHandle), "open it");
        return std::make_unique<UsbHid>(std::move(context), Handle(rawHandle), *interface);
    }
    return nullptr;
}

} // namespace autostereo::devices

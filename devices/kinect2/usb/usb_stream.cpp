#include "devices/kinect2/usb/usb_stream.hpp"

#include "devices/input.hpp"
#include "devices/kinect2/usb/find_units.hpp"

#include <libusb.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace autostereo::devices::kinect2 {

namespace {

/// A quarter of a second of isochronous transfers.
constexpr int kMostFailures = 64;
constexpr auto kInterval = std::chrono::microseconds(125); // USB 3, bInterval 1

/// Memory for one transfer: the kernel's own, which it fills without clearing it first and copying
/// it afterwards, else ours.
class TransferMemory {
  public:
    TransferMemory(libusb_device_handle* handle, std::size_t bytes)
        : handle_(handle), kernels_(libusb_dev_mem_alloc(handle, bytes), bytes),
          ours_(kernels_.data() == nullptr ? bytes : 0) {}
    ~TransferMemory() {
        if (kernels_.data() != nullptr)
            libusb_dev_mem_free(handle_, kernels_.data(), kernels_.size());
    }
    TransferMemory(const TransferMemory&) = delete;
    TransferMemory& operator=(const TransferMemory&) = delete;

    [[nodiscard]] std::span<unsigned char> bytes() {
        return kernels_.data() != nullptr ? kernels_ : std::span(ours_);
    }

  private:
    libusb_device_handle* handle_;
    std::span<unsigned char> kernels_;
    std::vector<unsigned char> ours_;
};

} // namespace

/// One transfer with its memory.
class UsbStream::Transfer {
  public:
    Transfer(UsbStream& stream, const Shape& shape, libusb_device_handle* handle)
        : stream_(stream), memory_(handle, static_cast<std::size_t>(shape.bytes())),
          raw_(libusb_alloc_transfer(shape.packets)) {
        if (!raw_) throw DeviceError("kinect2: no memory for USB transfers");
        unsigned char* bytes = memory_.bytes().data();
        if (shape.packets > 0) {
            libusb_fill_iso_transfer(raw_.get(), handle, shape.endpoint, bytes, shape.bytes(),
                                     shape.packets, whenEnded, this, 0);
            libusb_set_iso_packet_lengths(raw_.get(), static_cast<unsigned>(shape.packetBytes));
        } else {
            libusb_fill_bulk_transfer(raw_.get(), handle, shape.endpoint, bytes, shape.bytes(),
                                      whenEnded, this, 0);
        }
    }

    [[nodiscard]] libusb_transfer& raw() const { return *raw_; }
    [[nodiscard]] std::span<const std::byte> bytes() { return std::as_bytes(memory_.bytes()); }
    bool onItsWay = false;
    bool late = false; ///< packets before it may be missing

  private:
    struct Free {
        void operator()(libusb_transfer* transfer) const { libusb_free_transfer(transfer); }
    };
    static void LIBUSB_CALL whenEnded(libusb_transfer* raw) {
        auto& self = *static_cast<Transfer*>(raw->user_data);
        self.stream_.ended(self);
    }

    UsbStream& stream_;
    TransferMemory memory_;
    std::unique_ptr<libusb_transfer, Free> raw_;
};

UsbStream::UsbStream(UsbLink& link, const Shape& shape, Sink sink)
    : link_(link), shape_(shape), sink_(std::move(sink)) {
    if (shape.packets > 0) watch_.emplace(shape.packets * kInterval);
    for (int i = 0; i < shape.transfers; ++i) {
        transfers_.push_back(std::make_unique<Transfer>(*this, shape_, link_.handle()));
        submit(*transfers_.back());
        if (transfers_.back()->onItsWay) continue;
        const std::string why = link_.lost().value_or(
            "the kernel has no memory for its USB transfers, " + std::to_string(kUsbMemoryMib) +
            " MiB are needed: add usbcore.usbfs_memory_mb=64 to the kernel's command line");
        cancel();
        for (int turn = 0; !idle() && turn < shape.transfers; ++turn)
            link_.handleEvents(std::chrono::milliseconds(100));
        throw DeviceError("kinect2: cannot stream: " + why);
    }
}

UsbStream::~UsbStream() {
    // What the kernel does not give back may not be freed.
    for (auto& transfer : transfers_)
        if (transfer->onItsWay) static_cast<void>(transfer.release());
}

void UsbStream::submit(Transfer& transfer) {
    const TimePoint before = steadyNow();
    const int answer = libusb_submit_transfer(&transfer.raw());
    transfer.late = answer == 0 && watch_ && watch_->submitted(before, steadyNow());
    underruns_ += transfer.late ? 1 : 0;
    if (answer == LIBUSB_ERROR_NO_DEVICE) link_.lose("it was unplugged");
    transfer.onItsWay = answer == 0;
    onTheirWay_ += transfer.onItsWay ? 1 : 0;
}

void UsbStream::revive() {
    const TimePoint time = steadyNow();
    if (watch_ && !link_.somethingEnded()) watch_->noneEnded(time, onTheirWay_);
    for (const auto& transfer : transfers_)
        if (!transfer->onItsWay && !cancelled_ && !link_.lost()) submit(*transfer);
    if (idle() && !cancelled_) link_.lose("the kernel takes no USB transfers any more");
}

void UsbStream::cancel() {
    cancelled_ = true;
    for (const auto& transfer : transfers_)
        if (transfer->onItsWay) libusb_cancel_transfer(&transfer->raw());
}

void UsbStream::ended(Transfer& transfer) {
    --onTheirWay_;
    transfer.onItsWay = false;
    const libusb_transfer_status status = transfer.raw().status;
    if (status == LIBUSB_TRANSFER_NO_DEVICE) link_.lose("it was unplugged");
    if (cancelled_ || link_.lost()) return;
    if (status == LIBUSB_TRANSFER_COMPLETED)
        deliver(transfer);
    else
        countFailure(status);
    if (!link_.lost()) submit(transfer);
}

void UsbStream::deliver(Transfer& transfer) {
    failures_ = 0;
    if (transfer.late) sink_({}, true);
    const libusb_transfer& raw = transfer.raw();
    const auto bytes = transfer.bytes();
    if (shape_.packets == 0) {
        sink_(bytes.first(static_cast<std::size_t>(std::clamp(raw.actual_length, 0, raw.length))),
              true);
        return;
    }
    for (int i = 0; i < raw.num_iso_packets; ++i) {
        const libusb_iso_packet_descriptor& packet = raw.iso_packet_desc[i];
        const auto room = bytes.subspan(static_cast<std::size_t>(i) * packet.length, packet.length);
        const bool intact = packet.status == LIBUSB_TRANSFER_COMPLETED;
        sink_(room.first(std::min(packet.actual_length, packet.length)), intact);
    }
}

void UsbStream::countFailure(int status) {
    sink_({}, false);
    if (watch_) watch_->failed(steadyNow());
    if (status == LIBUSB_TRANSFER_STALL) link_.lose("it stopped a stream");
    if (++failures_ > kMostFailures) link_.lose("nothing comes through the bus any more");
}

} // namespace autostereo::devices::kinect2

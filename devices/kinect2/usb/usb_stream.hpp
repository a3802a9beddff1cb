#pragma once

#include "devices/kinect2/usb/underrun_watch.hpp"
#include "devices/kinect2/usb/usb_link.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace autostereo::devices::kinect2 {

/// Transfers of one IN endpoint that are always on their way, in order. What goes wrong with single
/// packets is the sink's to know; where isochronous ones may have been lost without a mark it gets
/// an empty one (see `UnderrunWatch`). An endpoint where nothing works any more loses the link.
/// Thread-bound: everything happens in the link's `handleEvents`.
class UsbStream {
  public:
    struct Shape {
        std::uint8_t endpoint = 0;
        int transfers = 0;
        int packets = 0; ///< of each transfer; 0: bulk
        int packetBytes = 0;

        [[nodiscard]] int bytes() const {
            return packets > 0 ? packets * packetBytes : packetBytes;
        }
    };
    /// One packet or bulk transfer; `intact`: the bus reports no error.
    using Sink = std::function<void(std::span<const std::byte> packet, bool intact)>;

    /// Throws DeviceError where the kernel does not take them all, with what to do. The link must
    /// outlive the stream.
    UsbStream(UsbLink& link, const Shape& shape, Sink sink);
    /// What is still on its way (see `idle`) is left to the kernel for ever.
    ~UsbStream();
    UsbStream(const UsbStream&) = delete;
    UsbStream& operator=(const UsbStream&) = delete;

    /// Sends again what the kernel had no memory for and looks how far the bus is: to be called
    /// before every `handleEvents`.
    void revive();
    /// Ends all transfers, one by one in `handleEvents`.
    void cancel();
    [[nodiscard]] bool idle() const { return onTheirWay_ == 0; }
    /// Transfers that came late, so that packets before them may be missing.
    [[nodiscard]] std::uint64_t underruns() const { return underruns_; }

  private:
    class Transfer;
    void ended(Transfer& transfer);
    void submit(Transfer& transfer);
    void deliver(Transfer& transfer);
    void countFailure(int status);

    UsbLink& link_;
    Shape shape_;
    Sink sink_;
    std::optional<UnderrunWatch> watch_; ///< isochronous
    std::vector<std::unique_ptr<Transfer>> transfers_;
    int onTheirWay_ = 0;
    int failures_ = 0; ///< transfers in a row that brought nothing
    std::uint64_t underruns_ = 0;
    bool cancelled_ = false;
};

} // namespace autostereo::devices::kinect2
